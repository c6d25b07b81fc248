using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// How well the facets of a scene follow the curved surfaces that they seem to stand for.
    /// </summary>
    /// <remarks>
    /// Two facets of width w across their common edge are chords of a circle of radius R. Each chord turns by w/R, so
    /// the edge bends by b = w/R, and the arc rises above the chord by the sagitta w^2/(8R) = w b/8. If the widths
    /// differ, the narrower one counts, for a wide facet may be flat, as a plate that ends in a fillet, and of the wide
    /// facet only a strip of that width is concerned. The sagitta of a facet is the sum over its three edges: on a
    /// cylinder two of them are straight lines of it and add nothing; on a sphere this is the distance of the facet
    /// from it, for facets that are half a square. Edges bent by 30 degrees or more are meant as edges, and those bent
    /// by no more than the rounding of float32 coordinates as none. The usual crease angle is smaller: a coarse curve
    /// with bends between them is cut into flat facets, and counts. A crease angle below the usual one says that bends
    /// from there on are edges, one above 30 degrees that those below it are not.
    /// </remarks>
    public sealed class MeshQuality
    {
        /// <summary>A sagitta above the wavelength over this number misleads: the path is off by 2/50 turns.</summary>
        public const double WavelengthsPerSagitta = 50;

        /// <summary>Bends from this angle on are meant as edges with the usual crease angle, degrees.</summary>
        public const double EdgeDegrees = 30;

        readonly double[] _sagittas; // descending
        readonly double[] _areas;    // sums of the areas up to each

        MeshQuality(List<(double sagitta, double area)> facets, double area, long openEdges)
        {
            facets.Sort((a, b) => b.sagitta.CompareTo(a.sagitta));
            _sagittas = new double[facets.Count];
            _areas = new double[facets.Count];
            double sum = 0;
            for (int i = 0; i < facets.Count; i++)
                (_sagittas[i], _areas[i]) = (facets[i].sagitta, sum += facets[i].area);
            Area = area;
            OpenEdgeCount = openEdges;
        }

        /// <summary>Area of all facets, m2, one side.</summary>
        public double Area { get; }

        /// <summary>Edges of one triangle.</summary>
        public long OpenEdgeCount { get; }

        /// <summary>Whether a mesh has edges of one triangle: a thin sheet that is lit from both sides.</summary>
        public bool IsOpen => OpenEdgeCount > 0;

        /// <summary>The largest sagitta, metres; 0 if all facets are flat or meet at edges.</summary>
        public double MaxSagitta => _sagittas.Length == 0 ? 0 : _sagittas[0];

        /// <summary>
        /// The frequency up to which no sagitta misleads, hertz; endless if all facets are flat or meet at edges.
        /// </summary>
        public double MaxFrequency => Signal.SpeedOfLight / (WavelengthsPerSagitta * MaxSagitta);

        /// <summary>Measures a scene.</summary>
        /// <param name="scene">The scene.</param>
        /// <param name="patches">The patches of each instance's mesh.</param>
        /// <exception cref="GlintException">The patches are not those of the scene's meshes.</exception>
        public static MeshQuality Find(RadarScene scene, IReadOnlyList<SurfacePatches> patches)
        {
            var facets = new List<(double, double)>();
            double area = 0;
            long openEdges = 0;
            foreach (var placed in PlacedPatches.Of(scene, patches))
            {
                openEdges += placed.Welded.OpenEdgeCount;
                for (int t = 0; t < placed.Welded.Mesh.TriangleCount; t++)
                {
                    double own = placed.TwiceArea(t) / 2;
                    area += own;
                    if (!placed.Patches.Normals.IsNeedle(t))
                        AddFacet(placed, t, own, facets);
                }
            }
            return new MeshQuality(facets, area, openEdges);
        }

        /// <summary>Share of the area whose sagitta is above 1/50 of a wavelength, 0 to 1.</summary>
        /// <param name="wavelength">Metres.</param>
        public double Share(double wavelength)
        {
            int count = 0;
            for (int above = _sagittas.Length; count < above;)
            {
                int centre = (count + above) / 2;
                if (_sagittas[centre] * WavelengthsPerSagitta > wavelength)
                    count = centre + 1;
                else
                    above = centre;
            }
            return count == 0 ? 0 : _areas[count - 1] / Area;
        }

        static void AddFacet(in PlacedPatches placed, int triangle, double area, List<(double, double)> facets)
        {
            double sum = 0, largest = 0, part = 0;
            for (int side = 3 * triangle; side < 3 * triangle + 3; side++)
            {
                double sagitta = Sagitta(placed, side, out double share);
                sum += sagitta;
                if (sagitta > largest)
                    (largest, part) = (sagitta, share);
            }
            if (sum > 0)
                facets.Add((sum, part * area));
        }

        static double EdgeOf(double creaseDegrees) => creaseDegrees < SurfacePatches.DefaultCreaseDegrees
            ? creaseDegrees
            : math.max(creaseDegrees, EdgeDegrees);

        // The share is that of the facet's width which the narrower facet has.
        static double Sagitta(in PlacedPatches placed, int side, out double share)
        {
            share = 0;
            int across = placed.Welded.Across(side);
            if (across == WeldedMesh.None)
                return 0;
            var normals = placed.Patches.Normals;
            double bend = placed.Bend(side, across),
                rounding = normals.Uncertainty(side / 3) + normals.Uncertainty(across / 3);
            double edge = math.radians(EdgeOf(placed.Patches.CreaseDegrees));
            if (!(bend > rounding && bend < edge) || normals.IsNeedle(across / 3))
                return 0;
            double own = placed.Width(side), width = math.min(own, placed.Width(across));
            share = width / own;
            return width * bend / 8;
        }
    }
}
