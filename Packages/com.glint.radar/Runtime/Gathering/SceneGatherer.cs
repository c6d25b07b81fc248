using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Collects the triangles of active GameObjects with an enabled MeshRenderer and a MeshFilter.
    /// A LODGroup contributes LOD 0. The order is that of the hierarchy. Unchanged data is kept from one gather to the
    /// next: if only known movers have moved, every TriangleMesh is the same object as before.
    /// </summary>
    /// <remarks>
    /// The scene has the world's axes and metres. Its origin is the nearest common transform of the radar, its receiver
    /// and all traced objects, whose own position does not matter; without one it is the world's origin. Objects that
    /// do not move relative to each other (a <see cref="RigidGroup"/>) are merged into one mesh, a <see
    /// cref="MergedMesh"/>, in a frame of their own. A transform moves if it differs from that of the last gather, or
    /// if <see cref="ExpectMotion"/> announced it, or if it has a Rigidbody or a <see cref="RadarMotion"/>. Objects
    /// whose mesh changes, or is used many times, are instances of their mesh, and so are the tiles of a sea with
    /// clutter. Vertices are rounded to float32 relative to such a frame, never to the scene; frames are in double.
    /// </remarks>
    public sealed class SceneGatherer
    {
        /// <summary>
        /// Maximum triangles of all copies of a mesh for merging; above it the objects are instances.
        /// </summary>
        public const long MaxMergedTriangles = 200_000;

        readonly VisibleRenderers _visible = new VisibleRenderers();
        readonly TransformTree _transforms = new TransformTree();
        readonly FrameCache<Mesh, MeshSource> _sources = new FrameCache<Mesh, MeshSource>();
        readonly FrameCache<TransformNode, MergedMesh> _mergedMeshes = new FrameCache<TransformNode, MergedMesh>();
        readonly List<RigidGroup> _groups = new List<RigidGroup>();
        readonly Dictionary<(RigidGroup, int3), MergedMesh> _cells = new Dictionary<(RigidGroup, int3), MergedMesh>();
        readonly List<(TransformNode node, Renderer renderer)> _objects = new List<(TransformNode, Renderer)>();
        readonly List<(MergedMesh merged, TransformNode lone)> _pieces = new List<(MergedMesh, TransformNode)>();
        readonly GatheredSeas _seas = new GatheredSeas();
        readonly List<SurfaceMaterial> _surfaces = new List<SurfaceMaterial>();
        readonly List<string> _warnings = new List<string>();
        MeshReader _reader = new MeshReader();
        RadarScene _scene;
        long _hashedBefore;
        bool _confirmsLater;

        /// <summary>How changed meshes are found.</summary>
        public MeshChanges MeshChanges { get; set; }

        /// <summary>Whether tiles and snapshots of seas are left out.</summary>
        public bool LeavesOutSeas { get; set; }

        /// <summary>Bytes of vertices and indices hashed since the last gather began.</summary>
        public long BytesHashed => _reader.BytesHashed - _hashedBefore;

        /// <summary>Number of objects with a mesh in the last gather.</summary>
        public int ObjectCount => _objects.Count;

        /// <summary>Objects that are not traced and why, and seas whose clutter is doubtful, a line each.</summary>
        public IReadOnlyList<string> Warnings => _warnings;

        /// <summary>Announces that a transform will move, so that its first motion costs nothing.</summary>
        /// <returns>False if it was announced already.</returns>
        public bool ExpectMotion(Transform transform) => _transforms.ExpectMotion(transform);

        /// <summary>
        /// Withdraws <see cref="ExpectMotion"/>. A transform that has moved counts as moving until <see
        /// cref="Forget"/>.
        /// </summary>
        public void ExpectNoMotion(Transform transform) => _transforms.ExpectNoMotion(transform);

        /// <summary>Gathers a scene.</summary>
        /// <param name="layers">Layers to trace.</param>
        /// <param name="roots">Objects to trace with all below them; empty: every loaded scene.</param>
        /// <param name="receiver">
        /// Not traced, with all below it: it is neither target nor obstacle. May be null.
        /// </param>
        /// <param name="radar">Transform of the radar; null: the scene's origin is the world's.</param>
        /// <param name="confirmLater">
        /// Watched meshes are not hashed here; the caller traces the scene and then calls <see cref="ConfirmMeshes"/>.
        /// </param>
        /// <returns>The scene; the same object as before if nothing has changed.</returns>
        /// <exception cref="GlintException">
        /// A mesh that cannot be traced; the message names it and the remedy.
        /// </exception>
        public RadarScene Gather(LayerMask layers, IReadOnlyList<Transform> roots,
            Transform receiver, Transform radar = null, bool confirmLater = false)
        {
            (_hashedBefore, _confirmsLater) = (_reader.BytesHashed, confirmLater);
            _transforms.Begin();
            _sources.Begin();
            _mergedMeshes.Begin();
            CollectObjects(layers, roots, receiver);
            var centre = FindCentre(radar, receiver);
            _transforms.Compose(centre);
            _surfaces.Clear();
            _surfaces.Add(SurfaceMaterial.PerfectConductor);
            var origin = centre.ToWorld().Origin;
            var instances = MakeInstances(origin);
            _transforms.End();
            _sources.End();
            _mergedMeshes.End();
            var scene = new RadarScene(instances)
            {
                Origin = origin, Surfaces = _surfaces.ToArray(), Seas = _seas.ToSeas()
            };
            if (_scene == null || !origin.Equals(_scene.Origin) || !scene.IsSame(_scene))
                _scene = scene;
            return _scene;
        }

        /// <summary>
        /// Hashes the meshes that the last gather left for later. It needs the main thread and no result of the trace, so
        /// that it can run while the device works.
        /// </summary>
        /// <returns>False if one has changed: gather and trace again, the next gather reads it.</returns>
        public bool ConfirmMeshes()
        {
            bool areUnchanged = true;
            foreach (var source in _sources.Values)
                areUnchanged &= source.Confirm(_reader);
            return areUnchanged;
        }

        /// <summary>
        /// Pose of the radar or the receiver in the scene of the last gather; the columns are its right, up and
        /// forward, unit vectors.
        /// </summary>
        public Affine PoseOf(Transform radarOrReceiver) => _transforms.Visit(radarOrReceiver).Pose();

        /// <summary>An object with a mesh of the last gather, by its number.</summary>
        public Transform ObjectAt(int number) => _objects[number].renderer.transform;

        /// <summary>
        /// Hash of the meshes of the last gather and their transforms, independent of their division into instances.
        /// Valid within one run only.
        /// </summary>
        public ulong Content()
        {
            var content = new ContentHash();
            content.Add(_objects.Count);
            foreach (var (node, _) in _objects)
            {
                content.Add(node.Source.Hash);
                content.Add(node.ToScene);
                for (int submesh = 0; submesh < node.Source.SubmeshTriangles.Length; submesh++)
                    content.Add(node.MaterialOf(submesh).GetHashCode());
            }
            foreach (var sea in _seas.ToSeas())
            {
                content.Add((ulong)sea.Clutter.Settings.Level);
                foreach (var measure in SeaClutterSettings.Measures)
                    content.Add((ulong)BitConverter.DoubleToInt64Bits(measure.Of(sea.Clutter.Settings)));
            }
            return content.Value;
        }

        /// <summary>Releases everything except announcements of motion.</summary>
        public void Forget()
        {
            _transforms.Forget();
            _sources.Clear();
            _mergedMeshes.Clear();
            _groups.Clear();
            _cells.Clear();
            _objects.Clear();
            _seas.Clear();
            _pieces.Clear();
            (_reader, _hashedBefore) = (new MeshReader(), 0);
            _scene = null;
        }

        void CollectObjects(LayerMask layers, IReadOnlyList<Transform> roots, Transform receiver)
        {
            _objects.Clear();
            _seas.Clear();
            _warnings.Clear();
            var skinned = new List<string>();
            foreach (var renderer in _visible.Find(layers, roots, receiver))
            {
                var node = _transforms.Visit(renderer.transform);
                if (node.IsTaken || LeavesOutSeas && IsSea(renderer)) // taken: below nested roots
                    continue;
                node.IsTaken = true;
                if (renderer is MeshRenderer)
                    AddObject(node, renderer);
                else if (renderer is SkinnedMeshRenderer)
                    skinned.Add(renderer.name);
            }
            if (skinned.Count > 0)
                _warnings.Add($"skinned meshes are not traced: '{string.Join("', '", skinned)}'. "
                    + "Bake them to a Mesh (SkinnedMeshRenderer.BakeMesh) to include them");
            var terrains = Terrains.Seen(layers, roots);
            if (terrains.Length > 0)
                _warnings.Add($"terrains are not traced: '{string.Join("', '", terrains)}'. Make meshes of them to "
                    + "include them");
            _warnings.AddRange(_seas.Warnings);
        }

        static bool IsSea(Renderer renderer) => renderer.TryGetComponent<SeaTile>(out _)
            || renderer.GetComponentInParent<SeaSnapshot>() != null;

        void AddObject(TransformNode node, Renderer renderer)
        {
            if (!renderer.TryGetComponent<MeshFilter>(out var filter))
                return;
            var mesh = filter.sharedMesh;
            if (mesh == null)
            {
                _warnings.Add($"MeshFilter of '{renderer.name}' has no mesh and is not traced: assign one, "
                    + "or disable its MeshRenderer");
                return;
            }
            if (renderer.isPartOfStaticBatch)
                throw new GlintException(InStaticBatch(renderer));
            if (!mesh.isReadable)
                throw new GlintException(NotReadable(mesh, renderer));

            var source = _sources.Get(mesh, out bool first);
            if (first)
                source.Update(mesh, _reader, renderer,
                    MeshChanges == MeshChanges.Watched && MeshWatch.IsWatched(mesh), _confirmsLater);
            source.AddObject();
            node.SetSource(source);
            node.CheckMaterials();
            if (node.SurfaceBeyond(source.SubmeshTriangles.Length) is RadarSurface unused)
                _warnings.Add($"RadarSurface of '{unused.name}' is that of submesh {unused.Submesh}, and mesh "
                    + $"'{mesh.name}' has {source.SubmeshTriangles.Length}, counted from 0: nothing has its material");
            node.ObjectNumber = _objects.Count;
            _seas.Visit(node, renderer);
            _objects.Add((node, renderer));
        }

        /// <summary>Why an object of a static batch is refused.</summary>
        public static string InStaticBatch(Renderer renderer) =>
            $"'{renderer.name}' is part of a static batch, whose meshes Unity has merged: "
            + $"clear Batching Static among the static flags of '{renderer.name}'";

        /// <summary>Why a mesh that scripts cannot read is refused.</summary>
        public static string NotReadable(Mesh mesh, Renderer renderer) =>
            $"mesh '{mesh.name}' of '{renderer.name}' is not readable: tick Read/Write in the mesh's import settings";

        // The transform of the scene's origin.
        TransformNode FindCentre(Transform radar, Transform receiver)
        {
            if (radar == null)
                return _transforms.World;
            var centre = _transforms.Visit(radar);
            if (receiver != null)
                centre = TransformNode.Common(centre, _transforms.Visit(receiver));
            foreach (var (node, _) in _objects)
                centre = TransformNode.Common(centre, node);
            return centre;
        }

        MeshInstance[] MakeInstances(double3 origin)
        {
            FindGroups();
            _cells.Clear();
            _pieces.Clear();
            foreach (var (node, renderer) in _objects)
            {
                node.Source.CheckTransform(node.ToScene, _reader, renderer);
                if (node.Source.TriangleCount > 0)
                    AddPiece(node, renderer);
            }
            var instances = new MeshInstance[_pieces.Count];
            for (int i = 0; i < instances.Length; i++)
            {
                var (merged, lone) = _pieces[i];
                instances[i] =
                    merged != null ? merged.MakeInstance(_reader) : lone.Source.MakeInstance(lone.ToScene, _reader);
                var nodes = merged != null ? merged.Nodes : new[] { lone };
                instances[i].Ranges = RangesOf(nodes);
                // Objects of a merged mesh move as one.
                instances[i].Motion = nodes[0].MotionIn(origin);
            }
            return instances;
        }

        // An object has one range, or one for each of its submeshes that has another surface than the one before.
        MeshRange[] RangesOf(IReadOnlyList<TransformNode> nodes)
        {
            var ranges = new List<MeshRange>(nodes.Count);
            int triangle = 0;
            foreach (var node in nodes)
            {
                int before = -1;
                for (int submesh = 0; submesh < node.Source.SubmeshTriangles.Length; submesh++)
                {
                    int surface = SurfaceOf(node.MaterialOf(submesh));
                    if (surface != before)
                        ranges.Add(new MeshRange(triangle, node.ObjectNumber, surface));
                    before = surface;
                    triangle += node.Source.SubmeshTriangles[submesh];
                }
            }
            return ranges.ToArray();
        }

        int SurfaceOf(SurfaceMaterial material)
        {
            int surface = _surfaces.IndexOf(material);
            if (surface < 0)
            {
                surface = _surfaces.Count;
                _surfaces.Add(material);
            }
            return surface;
        }

        void FindGroups()
        {
            _groups.Clear();
            foreach (var (node, _) in _objects)
            {
                if (node.Mover.Group == null)
                    _groups.Add(node.Mover.Group = new RigidGroup());
                node.Mover.Group.Add(node);
            }
            foreach (var group in _groups)
                group.ChooseFrame();
        }

        // Adds a separate instance, or a part of a merged mesh, which has the position of its first object.
        void AddPiece(TransformNode node, Renderer renderer)
        {
            if (_seas.HasTile(node))
            {
                _seas.Add(node, renderer.transform, _pieces.Count);
                _pieces.Add((null, node));
                return;
            }
            var source = node.Source;
            bool isApart = node.SwapsMesh || source.Version > 0;
            bool isRepeated = source.ObjectCount > 1
                && source.ObjectCount * (long)source.TriangleCount > MaxMergedTriangles;
            double conditioning = TransformMath.Conditioning(node.ToScene);
            if (isApart && conditioning >= TransformMath.SimilarConditioning
                || isRepeated && conditioning >= TransformMath.MinConditioning)
            {
                _pieces.Add((null, node));
                return;
            }
            var group = node.Mover.Group;
            if (isApart)
            {
                AddMergedMesh(node, group);
                return;
            }
            var cell = (group, group.Cell(node));
            if (_cells.TryGetValue(cell, out var merged))
                merged.Add(node);
            else
                _cells.Add(cell, AddMergedMesh(node, group));
        }

        MergedMesh AddMergedMesh(TransformNode first, RigidGroup group)
        {
            var merged = _mergedMeshes.Get(first, out _);
            merged.Begin(first, group);
            _pieces.Add((merged, null));
            return merged;
        }
    }
}
