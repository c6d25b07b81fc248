using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Random poses of ten targets, and of three at a finite range: the same for a number on any machine.</summary>
    static class ErrorPose
    {
        // The same bodies at a finite range, m.
        const string Near = "near_";
        const double MinRange = 1.5, MaxRange = 20;

        public static readonly string[] Targets =
        {
            "plate", "plate_with_edges", "dihedral", "trihedral", "sphere", "cylinder", "top_hat", "two_plates",
            "coated_box", "ship", Near + "plate", Near + "dihedral", Near + "trihedral"
        };

        // The coarsest tubes of the truths (ErrorTruth.Fineness): 16 to 64 times finer than kernels find borders at first. What
        // lies between the rays of undivided tubes is not found, so that these are as fine as the thinnest parts of plates seen
        // at grazing incidence; round bodies have none. One of the plates at a finite range is lit at 1.5 degrees and received
        // from its side: 64 tubes a wavelength are 4 % off there. A phase that is taken as linear has a mean error of a third
        // of this.
        public static TubeSettings TruthSettingsOf(string target)
        {
            bool isRound = target == "sphere" || target == "cylinder", isThin = target == Near + "plate";
            return new TubeSettings
            {
                CellsPerWavelength = isRound ? 2 : isThin ? 256 : 64, MaxDepth = isRound ? 8 : isThin ? 3 : 5,
                MaxPhaseError = 0.005
            };
        }

        // Cosine of the largest angle between radar and receiver at which physical optics holds.
        const double MinBistaticCosine = -0.5;

        public static bool IsNear(string target) => target.StartsWith(Near, StringComparison.Ordinal);

        public static RadarScene SceneOf(string target)
        {
            switch (target.Replace(Near, ""))
            {
                case "plate":
                case "plate_with_edges": return new RadarScene(CrossSectionTargets.Plate(0.3, 0.2));
                case "dihedral": return new RadarScene(CrossSectionTargets.Dihedral(0.2, 0.15));
                case "trihedral":
                    return new RadarScene(
                        CrossSectionTargets.Trihedral(0.2, CrossSectionTargets.TrihedralFace.Triangular));
                case "sphere": return new RadarScene(Convex(CrossSectionTargets.Sphere(0.1, 32)));
                case "cylinder": return new RadarScene(CrossSectionTargets.Cylinder(0.04, 0.12, 180, true));
                case "top_hat": return new RadarScene(CrossSectionTargets.TopHat(0.03, 0.06, 0.1, 180));
                case "two_plates": return new RadarScene(CrossSectionTargets.TwoPlates(0.15, 0.15, 0.25));
                case "coated_box": return CoatedBox();
                default: return Ship();
            }
        }

        /// <summary>A pose of a target: every fourth is bistatic, and one of three tolerances is asked for.</summary>
        public static CrossSectionPose Of(string target, RadarScene scene, int number)
        {
            var random = new System.Random(1000 * Array.IndexOf(Targets, target) + number);
            double Within(double from, double to) => from + (to - from) * random.NextDouble();
            RadarAspect Aspect() =>
                RadarAspect.At(Within(-180, 180), math.degrees(Math.Asin(Within(-1, 1))));
            RadarAspect radar = Aspect(), receiver = radar;
            if (number % 4 == 3)
                do
                    receiver = Aspect();
                while (math.dot(receiver.ToRadar, radar.ToRadar) < MinBistaticCosine);
            var pose = new CrossSectionPose
            {
                Scene = scene, Radar = radar, Receivers = new[] { receiver },
                Frequencies = new[] { Within(8e9, 12e9) }, MaxBounces = 4, HasEdges = target != "plate",
                ToleranceDb = new[] { 0.1, 0.3, 1 }[number % 3], Polarisations = Polarisation.All
            };
            if (IsNear(target))
                pose.Range = Math.Exp(Within(Math.Log(MinRange), Math.Log(MaxRange)));
            return pose;
        }

        /// <summary>
        /// What errors of VV and HH, or of HV and VH, are relative to: the smaller one, or the floor; metres.
        /// </summary>
        public static double ScaleOf(ScatteringMatrix s, double floorDbsm, bool isCross = false) => PairOf(isCross)
            .Min(each => CrossSectionAccuracy.ScaleOf(each.Of(s), floorDbsm));

        /// <summary>VV and HH, or HV and VH.</summary>
        public static IEnumerable<Polarisation> PairOf(bool isCross) =>
            Polarisation.All.Where(each => each.IsCross == isCross);

        // A sphere whose quads, of two triangles each, are cut along ridges. In grooves between triangles rays are mirrored twice
        // at grazing incidence: which do differs from grid to grid.
        static TriangleMesh Convex(TriangleMesh sphere)
        {
            var corners = (int[])sphere.Indices.Clone();
            for (int i = 0; i < corners.Length; i += 6)
            {
                // The first triangle has corners a, c and b, the second one a, d and c.
                int a = corners[i], b = corners[i + 2], c = corners[i + 1], d = corners[i + 4];
                float3 Sum(int first, int second) => sphere.Vertices[first] + sphere.Vertices[second];
                if (math.lengthsq(Sum(b, d)) > math.lengthsq(Sum(a, c)))
                    new[] { b, a, d, b, d, c }.CopyTo(corners, i);
            }
            return new TriangleMesh(sphere.Vertices, corners);
        }

        // Three sides have a layer on metal; the others are those of a dielectric.
        static RadarScene CoatedBox()
        {
            var layer = new SurfaceMaterial("layer", new[] { new MaterialLayer(Medium.Constant(4, 0.4), 0.002) });
            var dielectric = new SurfaceMaterial("dielectric", halfSpace: Medium.Constant(5, 1));
            return new RadarScene(new MeshInstance
            {
                Mesh = CrossSectionTargets.Box(0.25, 0.15, 0.1), ToWorld = Affine.Identity,
                Ranges = new[] { new MeshRange(0, MeshRange.NoObject, 0), new MeshRange(6, MeshRange.NoObject, 1) }
            })
            { Surfaces = new[] { layer, dielectric } };
        }

        // A hull with raked ends, a deckhouse and a mast, which reach into each other.
        static RadarScene Ship()
        {
            var box = CrossSectionTargets.Box(1, 1, 1);
            MeshInstance Part(TriangleMesh mesh, double3 size, double3 rake, double3 at) => new MeshInstance
            {
                Mesh = mesh,
                ToWorld = new Affine
                {
                    X = new double3(size.x, 0, 0), Y = new double3(0, size.y, 0) + rake, Z = new double3(0, 0, size.z),
                    Origin = at
                }
            };
            return new RadarScene(
                Part(box, new double3(0.08, 0.06, 0.4), new double3(0, 0, 0.02), 0),
                Part(box, new double3(0.05, 0.06, 0.1), new double3(0.008, 0, 0), new double3(0, 0.05, -0.05)),
                Part(CrossSectionTargets.Cylinder(0.012, 0.1, 36, true), 1, 0, new double3(0, 0.12, -0.03)));
        }
    }
}
