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
        /// <summary>Labels and tooltips of the fields of <see cref="ShipSettings"/>, in their order.</summary>
        public static readonly (string field, string label, string tooltip)[] Measures =
        {
            ("Length", "Length (m)", "From the stern to the tip of the bow: 55 to 90 m."),
            ("Beam", "Beam (m)", "Greatest width of the deck: 11 to 16 m."),
            ("Freeboard", "Freeboard (m)", "Height above the water of the deck aft of the deckhouse: 1.5 to 6 m."),
            ("Forecastle", "Forecastle (m)",
                "How much higher the deck lies before the deckhouse than aft of it: 0 to 3 m."),
            ("Draught", "Draught (m)", "How far the keel lies below the water: 2 to 8 m."),
            ("Sheer", "Sheer (m)", "How much the deck rises from before the deckhouse to the bow: 0 to 3 m."),
            ("Rake", "Rake (m)", "How far the tip of the bow reaches out over the stem at the water: 0 to 6 m."),
            ("Flare", "Flare",
                "How much finer the bow is at the keel than at the deck: 0 (as upright as amidships) to 0.8."),
            ("Transom", "Transom (of beam)", "Width of the flat transom at the deck: 0.4 to 1."),
            ("HouseFront", "House Front (of length)", "From the middle of the ship forward to the flat front of the "
                + "deckhouse: 0.28 to 0.36. With the deck before it it is a dihedral: the peak bow-on."),
            ("HouseAft", "House Aft (of length)", "From the middle of the ship aft to the flat end of the deckhouse: "
                + "0.2 to 0.34. With the deck behind it it is a dihedral: the peak stern-on."),
            ("StoreyHeight", "Storey Height (m)", "Of each of the three storeys over the one below: 2 to 4 m."),
            ("Windows", "Windows", "Across the bridge's front, 1 to 15; each side has two thirds as many."),
            ("WindowDepth", "Window Depth (m)", "How deep the windows are set into the bridge: 0.02 to 0.5 m. Sill, "
                + "jambs and pane are small corner reflectors."),
            ("MastHeight", "Mast Height (m)", "Of the mast's top over the bridge's roof: 5 to 20 m."),
            ("Triangles", "Triangles", "Of the whole ship, 15,000 to 200,000, met within 2 %."),
        };

        /// <summary>Which measure is out of range; null if none is.</summary>
        public static Finding Check(Ship ship)
        {
            try
            {
                ship.Settings.Validate();
                return null;
            }
            catch (GlintException problem)
            {
                return new Finding(Severity.Error, problem.Message);
            }
        }

        /// <summary>Label, value and meaning.</summary>
        public static IEnumerable<(string label, string value, string tooltip)> Rows(Ship ship)
        {
            var mesh = ship.TryGetComponent<MeshFilter>(out var filter) ? filter.sharedMesh : null;
            if (mesh == null)
                yield break;
            var size = mesh.bounds.size;
            yield return ("Mesh", FormattableString.Invariant(
                    $"{size.z:0.##} x {size.x:0.##} x {size.y:0.##} m, {mesh.GetIndexCount(0) / 3:N0} triangles"),
                "Length, width and height of what is traced. The bow points to -Z, the water is at y = 0.");
        }

        /// <summary>
        /// Makes the mesh from measures that pass <see cref="Check"/>. It is stored with the scene.
        /// </summary>
        public static Fix Remake(Ship ship) => new Fix("Make the mesh anew", () =>
        {
            var mesh = Make(ship.Settings);
            Undo.RegisterCreatedObjectUndo(mesh, "Make the mesh anew");
            Fix.Change(ship.GetComponent<MeshFilter>(), "Make the mesh anew", it => it.sharedMesh = mesh);
        });

        /// <exception cref="GlintException">A measure is out of range.</exception>
        public static Mesh Make(in ShipSettings measures)
        {
            var made = ShipModel.Build(measures);
            return MeshMaker.Make("Ship", made.Vertices, made.Indices);
        }
    }
}
