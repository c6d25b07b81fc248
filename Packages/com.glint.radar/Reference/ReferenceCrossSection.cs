using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>How finely a cross section is integrated.</summary>
    public struct TubeSettings
    {
        /// <summary>
        /// 2 tubes a wavelength, cut up to 7 times; phases linear within 0.02 rad. Enough for each of the published
        /// cases, a sphere with abrupt shadows included.
        /// </summary>
        public static TubeSettings Default =>
            new TubeSettings { CellsPerWavelength = 2, MaxDepth = 7, MaxPhaseError = 0.02 };

        /// <summary>Undivided tubes along a wavelength of the highest frequency.</summary>
        public double CellsPerWavelength { get; set; }

        /// <summary>How often a tube at a border may be divided into 2 x 2.</summary>
        public int MaxDepth { get; set; }

        /// <summary>Deviation of the phase from a linear one in an undivided tube, radians.</summary>
        public double MaxPhaseError { get; set; }
    }

    /// <summary>
    /// The radar cross section by tubes of rays and physical optics, in double precision and plain loops: what the
    /// kernels are compared with. It shares no code with them.
    /// </summary>
    public sealed class ReferenceCrossSection
    {
        readonly RadarScene _scene;
        readonly double _creaseDegrees;
        readonly ReferenceBvh _bvh;
        readonly SmoothedSurface _smoothed;
        readonly Lazy<IReadOnlyList<Wedge>> _wedges;

        /// <summary>The cross sections of a scene.</summary>
        /// <param name="creaseDegrees">Bend of an edge above which it is sharp.</param>
        public ReferenceCrossSection(RadarScene scene, double creaseDegrees = CrossSectionPose.DefaultCreaseDegrees)
        {
            _scene = scene;
            _creaseDegrees = creaseDegrees;
            _bvh = new ReferenceBvh(scene);
            var patches = Array.ConvertAll(scene.Instances,
                instance => SurfacePatches.Find(instance.Mesh, instance.Ranges, creaseDegrees));
            _smoothed = new SmoothedSurface(_bvh, scene, patches);
            _wedges = new Lazy<IReadOnlyList<Wedge>>(
                () => WedgeFinder.Find(scene, patches, material => material.IsConductor).Wedges);
        }

        internal static double Wavenumber(double frequency) => 2 * math.PI_DBL * frequency / Signal.SpeedOfLight;

        /// <summary>Scattering matrices by receiver and frequency.</summary>
        /// <exception cref="ArgumentException">The pose has another scene or crease angle.</exception>
        /// <exception cref="GlintException">
        /// The radar is within or beside the target, or a material has no data at a frequency.
        /// </exception>
        public ScatteringMatrix[,] Compute(CrossSectionPose pose, in TubeSettings settings)
        {
            if (pose.Scene != _scene || pose.CreaseDegrees != _creaseDegrees)
                throw new ArgumentException("the pose has another scene or crease angle than the tracer", nameof(pose));
            var receivers = pose.Receivers.Select(at => new CrossSectionReceiver(at, pose, _bvh.Centre)).ToArray();
            var total = new ScatteringMatrix[receivers.Length, pose.Frequencies.Length];
            AddTubes(pose, settings, receivers, total);
            if (pose.HasEdges)
                new FringeField(pose, _bvh, receivers, _wedges.Value).Add(total);
            return total;
        }

        void AddTubes(CrossSectionPose pose, in TubeSettings settings, CrossSectionReceiver[] receivers,
            ScatteringMatrix[,] total)
        {
            double maxWavenumber = Wavenumber(pose.Frequencies.Max());
            double size = 2 * math.PI_DBL / maxWavenumber / settings.CellsPerWavelength;
            var grid = new WavefrontGrid(pose, _bvh);
            var tracer = new TubeTracer(pose, grid, _bvh, _smoothed, receivers);
            var border = new TubeBorder(receivers, settings.MaxPhaseError / maxWavenumber);
            var field = new TubeField(pose, receivers);
            int maxDepth = settings.MaxDepth;
            var blocks = (int2)math.ceil((grid.Max - grid.Min) / (TubeBlock.Cells * size));
            var sums = new ScatteringMatrix[blocks.x * blocks.y][,];
            Parallel.For(0, sums.Length, i =>
            {
                double2 corner = grid.Min + TubeBlock.Cells * size * new double2(i % blocks.x, i / blocks.x);
                sums[i] = new ScatteringMatrix[receivers.Length, pose.Frequencies.Length];
                new TubeBlock(tracer, border, corner, size).Add(maxDepth, field, sums[i]);
            });

            // In the order of the blocks, whichever core was first.
            foreach (var sum in sums)
                for (int r = 0; r < receivers.Length; r++)
                    for (int f = 0; f < pose.Frequencies.Length; f++)
                        total[r, f] += sum[r, f];
        }
    }
}
