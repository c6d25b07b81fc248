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
        /// <summary>1 tube a wavelength, cut up to 6 times; phases linear within 0.1 rad.</summary>
        public static TubeSettings Default =>
            new TubeSettings { CellsPerWavelength = 1, MaxDepth = 6, MaxPhaseError = 0.1 };

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
        readonly CrossSectionPose _pose;
        readonly TubeSettings _settings;
        readonly ReferenceBvh _bvh;
        readonly CrossSectionReceiver[] _receivers;
        readonly WavefrontGrid _grid;
        readonly TubeTracer _tracer;
        readonly TubeBorder _border;
        readonly TubeField _field;
        readonly FringeField _fringes;
        readonly double _maxWavenumber;

        /// <summary>The cross section of a pose.</summary>
        /// <param name="patches">Patch of each triangle, in the scene's order.</param>
        /// <param name="cornerNormals">Mean normals at the corners, three a triangle; null: all patches are flat.</param>
        /// <param name="surfaces">For each surface of the scene.</param>
        /// <param name="wedges">Edges with fringe fields.</param>
        public ReferenceCrossSection(CrossSectionPose pose, in TubeSettings settings, int[] patches,
            double3[] cornerNormals, IReadOnlyList<ReferenceSurface> surfaces, IReadOnlyList<ReferenceWedge> wedges)
        {
            _pose = pose;
            _settings = settings;
            _bvh = new ReferenceBvh(pose.Scene);
            _receivers = pose.Receivers.Select(at => new CrossSectionReceiver(at, pose, _bvh.Centre)).ToArray();
            _grid = new WavefrontGrid(pose, _bvh);
            _tracer = new TubeTracer(pose, _grid, _bvh, new SmoothedSurface(_bvh, patches, cornerNormals), _receivers);
            _field = new TubeField(pose, _receivers, surfaces);
            _fringes = new FringeField(pose, _bvh, _receivers, wedges);
            _maxWavenumber = Wavenumber(pose.Frequencies.Max());
            _border = new TubeBorder(_receivers, settings.MaxPhaseError / _maxWavenumber);
        }

        internal static double Wavenumber(double frequency) => 2 * math.PI_DBL * frequency / Signal.SpeedOfLight;

        /// <summary>Scattering matrices by receiver and frequency.</summary>
        public ScatteringMatrix[,] Compute()
        {
            double size = 2 * math.PI_DBL / _maxWavenumber / _settings.CellsPerWavelength;
            var blocks = (int2)math.ceil((_grid.Max - _grid.Min) / (TubeBlock.Cells * size));
            var sums = new ScatteringMatrix[blocks.x * blocks.y][,];
            Parallel.For(0, sums.Length, i =>
            {
                double2 corner = _grid.Min + TubeBlock.Cells * size * new double2(i % blocks.x, i / blocks.x);
                sums[i] = NewSums();
                new TubeBlock(_tracer, _border, corner, size).Add(_settings.MaxDepth, _field, sums[i]);
            });

            // In the order of the blocks, whichever core was first.
            var total = NewSums();
            foreach (var sum in sums)
                Add(sum, total);
            if (_pose.HasEdges)
                _fringes.Add(total);
            return total;
        }

        ScatteringMatrix[,] NewSums() => new ScatteringMatrix[_receivers.Length, _pose.Frequencies.Length];

        static void Add(ScatteringMatrix[,] part, ScatteringMatrix[,] sums)
        {
            for (int r = 0; r < sums.GetLength(0); r++)
                for (int f = 0; f < sums.GetLength(1); f++)
                    sums[r, f] += part[r, f];
        }
    }
}
