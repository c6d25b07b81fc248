using System.Runtime.CompilerServices;
using Glint.Core;
using UnityEngine;
#if UNITY_EDITOR
using UnityEditor;
#endif

namespace Glint
{
    /// <summary>How a radar learns that a mesh has changed.</summary>
    public enum MeshChanges
    {
        /// <summary>
        /// Meshes made at run time by other scripts are read beside each pose. A change is always seen.
        /// </summary>
        Watched,

        /// <summary>
        /// No mesh is read. Scripts that change one call <see cref="RadarController.MarkChanged"/>.
        /// </summary>
        Declared
    }

    /// <summary>
    /// Says whether a mesh may have changed since it was read, because Unity has no public version of a mesh. What a
    /// mesh costs per pose depends on who made it:
    /// <list type="bullet">
    /// <item>filled by <see cref="MeshMaker"/>, which marks each change: its signs alone;</item>
    /// <item>stored as an asset, in edit mode: its signs alone, which include its dirty count;</item>
    /// <item>any other: its signs, and a hash of its content beside the pose (<see cref="IsWatched"/>).</item>
    /// </list>
    /// In play mode a stored asset belongs to the third kind: a script may change it without marking it dirty, and a
    /// player does not know what is stored.
    /// </summary>
    static class MeshWatch
    {
        // Weak, so that marks keep no mesh alive. A mesh whose marks are lost is watched.
        static readonly ConditionalWeakTable<Mesh, Marks> s_marks = new ConditionalWeakTable<Mesh, Marks>();

        /// <summary>Marks a mesh as changed. Any radar reads it in its next pose.</summary>
        /// <exception cref="GlintException">There is no mesh.</exception>
        public static void MarkChanged(Mesh mesh)
        {
            if (mesh == null)
                throw new GlintException("MarkChanged: the mesh is missing or destroyed: give it the changed mesh");
            MarksOf(mesh).Changes++;
        }

        /// <summary>The same for a mesh that was just filled by its maker, which will mark all its changes.</summary>
        public static void MarkFilled(Mesh mesh)
        {
            MarkChanged(mesh);
            MarksOf(mesh).IsDeclared = true;
        }

        /// <summary>Whether the mesh may change without a change of its <see cref="Signs"/>.</summary>
        public static bool IsWatched(Mesh mesh) =>
            !(s_marks.TryGetValue(mesh, out var marks) && marks.IsDeclared) && !IsStored(mesh);

        /// <summary>
        /// What tells a change without reading the content: marks, counts, bounds, and the state of a stored asset.
        /// </summary>
        public static ulong Signs(Mesh mesh)
        {
            var signs = new ContentHash();
            signs.Add(s_marks.TryGetValue(mesh, out var marks) ? marks.Changes : 0);
            signs.Add(mesh.vertexCount);
            signs.Add(mesh.subMeshCount);
            for (int submesh = 0; submesh < mesh.subMeshCount; submesh++)
            {
                signs.Add((int)mesh.GetTopology(submesh));
                signs.Add((int)mesh.GetIndexCount(submesh));
            }
            var bounds = mesh.bounds;
            signs.Add(bounds.center);
            signs.Add(bounds.extents);
            AddAssetState(ref signs, mesh);
            return signs.Value;
        }

#if UNITY_EDITOR
        static bool IsStored(Mesh mesh) => !Application.isPlaying && AssetDatabase.Contains(mesh);

        // Saving resets the dirty count, and importing does not change it: both change the version of the database.
        static void AddAssetState(ref ContentHash signs, Mesh mesh)
        {
            signs.Add(EditorUtility.GetDirtyCount(mesh));
            if (AssetDatabase.Contains(mesh))
                signs.Add((int)AssetDatabase.GlobalArtifactDependencyVersion);
        }
#else
        static bool IsStored(Mesh mesh) => false;

        static void AddAssetState(ref ContentHash signs, Mesh mesh) { }
#endif

        static Marks MarksOf(Mesh mesh) => s_marks.GetValue(mesh, _ => new Marks());

        sealed class Marks
        {
            public int Changes;
            public bool IsDeclared;
        }
    }
}
