using System;
using System.Collections.Generic;
using Glint.Core;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>A ship's mesh and its measures for an inspector.</summary>
    static class ShipFigures
    {
        /// <summary>Finding for a measure out of range; null if none is.</summary>
        public static Finding Check(Ship ship) => Finding.Of(() => ship.Settings.Validate());

        /// <summary>Label, value and meaning.</summary>
        public static IEnumerable<(string label, string value, string tooltip)> Rows(Ship ship)
        {
            var mesh = ship.TryGetComponent<MeshFilter>(out var filter) ? filter.sharedMesh : null;
            if (mesh == null)
                yield break;
            var size = mesh.bounds.size;
            yield return ("Mesh", FormattableString.Invariant(
                    $"{size.z:0.##} x {size.x:0.##} x {size.y:0.##} m, {mesh.GetIndexCount(0) / 3:N0} triangles"),
                "Length, width and height of the mesh. The bow points to -Z, the water is at y = 0.");
        }

        /// <summary>
        /// Makes the mesh from measures that pass <see cref="Check"/>. It is stored with the scene.
        /// </summary>
        public static Fix Remake(Ship ship) => new Fix("Rebuild the mesh", () =>
        {
            var mesh = Make(ship.Settings);
            Undo.RegisterCreatedObjectUndo(mesh, "Rebuild the mesh");
            Fix.Change(ship.GetComponent<MeshFilter>(), "Rebuild the mesh", it => it.sharedMesh = mesh);
        });

        /// <exception cref="GlintException">A measure is out of range.</exception>
        public static Mesh Make(in ShipSettings measures)
        {
            var made = ShipModel.Build(measures);
            return MeshMaker.Make("Ship", made.Vertices, made.Indices);
        }
    }
}
