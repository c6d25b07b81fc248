using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// The swell of a sea: waves that come from a distant storm, in a narrow band of frequencies and directions. The
    /// variance is Gaussian over frequency and cos^2s of half the angle over directions. Sources:
    /// Documentation~/sea.md.
    /// </summary>
    readonly struct Swell
    {
        /// <summary>
        /// Standard deviation of the frequency over that of the peak: as peaked (Goda's Qp) as JONSWAP's spectrum with
        /// an enhancement of 8 to 9, which Goda (1983) found for swell that has travelled far.
        /// </summary>
        public const double RelativeWidth = 0.11;

        /// <summary>Goda's s of swell from afar (Goda and Suzuki 1975): a standard deviation of 9 degrees.</summary>
        public const double Spreading = 75;

        // Of a wave's density over that of the peak: lower ones are left out.
        const double MinDensity = 1e-9;

        readonly double _number, _peak, _x, _z, _variance;

        /// <summary>The swell of valid settings.</summary>
        public Swell(in SeaSettings settings)
        {
            _number = 2 * Math.PI / settings.TileSize;
            _peak = 2 * Math.PI / settings.SwellPeriod;
            (_x, _z) = PortableMath.SinCos(settings.SwellDirectionDegrees / 360);
            double height = settings.SwellHeight * settings.HeightFactor / 4;
            _variance = height * height;
        }

        /// <summary>Length in metres of a deep-water wave of a period in seconds.</summary>
        public static double Length(double period) => SeaSpectrum.Gravity * period * period / (2 * Math.PI);

        /// <summary>
        /// Waves of a grid that travel with the swell, and the variance of each, m2. Together they have the swell's
        /// height.
        /// </summary>
        /// <param name="reach">Largest column and row.</param>
        public IReadOnlyList<(int Column, int Row, double Variance)> Variances(int reach)
        {
            var waves = new List<(int Column, int Row, double Density)>();
            for (int row = -reach; row <= reach; row++)
                for (int column = -reach; column <= reach; column++)
                {
                    double density = Density(column, row);
                    if (density > MinDensity)
                        waves.Add((column, row, density));
                }
            double scale = _variance / waves.Sum(wave => wave.Density);
            return waves.Select(wave => (wave.Column, wave.Row, scale * wave.Density)).ToList();
        }

        // Variance a wave vector, over that of the peak: from frequency to wave number by dw/dk = g / 2w.
        double Density(int column, int row)
        {
            double length = Math.Sqrt((double)row * row + (double)column * column);
            double cosine = length > 0 ? (column * _x + row * _z) / length : 0;
            if (!(cosine > 0))
                return 0;
            double ratio = Math.Sqrt(SeaSpectrum.Gravity * _number * length) / _peak, off = (ratio - 1) / RelativeWidth;
            return PortableMath.Exp(-0.5 * off * off + Spreading * PortableMath.Log((1 + cosine) / 2))
                / (ratio * ratio * ratio);
        }
    }
}
