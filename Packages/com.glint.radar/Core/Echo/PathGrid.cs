using System;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// The responses of many paths over a band, by a grid over the length of the path: the work for a path does not
    /// depend on the number of frequencies. A path of length L (metres, out and back) and amplitude A adds
    /// A exp(-j 2 pi f L / c) at each frequency f.
    /// </summary>
    /// <remarks>
    /// A path is spread over some neighbouring cells by a Kaiser-Bessel kernel, with the exact phase of the carrier.
    /// The Fourier transform of the grid, divided by that of the kernel, gives the responses (Beatty, Nishimura and
    /// Pauly, IEEE Trans. Med. Imaging 24 (2005) 799). The power of the error is 1e-10 of the responses'.
    /// </remarks>
    public sealed class PathGrid
    {
        // Cells that a path is spread over; cells a frequency, before they are rounded up to a power of two.
        const int Taps = 6, Oversampling = 2;

        readonly FrequencyBand _band;
        readonly FourierTransform _transform;
        readonly Complex[] _cells;

        // b of the kernel, and exp(-b) I0(b).
        readonly double _steepness, _peak;

        // Index of the frequency whose phase is exact.
        readonly int _centre;

        /// <summary>A grid without paths.</summary>
        public PathGrid(FrequencyBand band)
        {
            _band = band;
            _centre = band.Count / 2;
            _transform = new FourierTransform(FourierTransform.SizeFor(Math.Max(Taps, Oversampling * band.Count)));
            _cells = new Complex[_transform.Size];
            double ratio = (double)_cells.Length / band.Count, width = Taps / ratio * (ratio - 0.5);
            _steepness = Math.PI * Math.Sqrt(width * width - 0.8);
            _peak = RoughnessLoss.ScaledBessel(_steepness);
        }

        /// <summary>Adds a path of this length, metres out and back.</summary>
        public void Add(double length, Complex amplitude)
        {
            var (sine, cosine) = PortableMath.SinCos(-_band.Frequency(_centre) * length / Signal.SpeedOfLight);
            var atCarrier = amplitude * new Complex(cosine, sine);
            double periods = length * _band.Step / Signal.SpeedOfLight,
                position = (periods - Math.Floor(periods)) * _cells.Length;
            int first = (int)Math.Ceiling(position - 0.5 * Taps);
            for (int cell = first; cell < first + Taps; cell++)
                _cells[cell & (_cells.Length - 1)] += atCarrier * Kernel(2 * (cell - position) / Taps);
        }

        /// <summary>The sum over all paths at each frequency.</summary>
        public Complex[] Responses()
        {
            var spectrum = _transform.Transform(_cells, isPositive: false);
            var responses = new Complex[_band.Count];
            for (int n = 0; n < responses.Length; n++)
            {
                int offset = n - _centre;
                responses[n] = spectrum[offset & (_cells.Length - 1)] / KernelTransform(offset);
            }
            return responses;
        }

        /// <summary>Removes all paths.</summary>
        public void Clear() => Array.Clear(_cells, 0, _cells.Length);

        // I0(b sqrt(1 - x^2)) / I0(b), x from -1 to 1.
        double Kernel(double x)
        {
            double argument = _steepness * Math.Sqrt(Math.Max(0, 1 - x * x));
            return PortableMath.Exp(argument - _steepness) * RoughnessLoss.ScaledBessel(argument) / _peak;
        }

        // Taps sinh(z) / z / I0(b), z = sqrt(b^2 - (pi Taps n / cells)^2).
        double KernelTransform(int n)
        {
            double turn = Math.PI * Taps * n / _cells.Length, z = Math.Sqrt(_steepness * _steepness - turn * turn);
            return Taps * (PortableMath.Exp(z - _steepness) - PortableMath.Exp(-z - _steepness)) / (2 * z * _peak);
        }
    }
}
