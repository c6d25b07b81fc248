using System;
using System.Numerics;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Sigma0 of a mesh's facets whose unresolved slopes are Gaussian, for one frequency, wind and facet size: a table
    /// of Bragg scattering for every direction of facet and radar, and mirror points. It is what a kernel reads.
    /// </summary>
    public sealed class FacetTable
    {
        /// <summary>
        /// Rows over sqrt(1 - cosine) of the incidence on the facet, which has fine steps at the mirror direction and
        /// at grazing.
        /// </summary>
        public const int Rows = 257;

        /// <summary>Columns over the squared sine of the angle to the wind, 0 to 1.</summary>
        public const int Columns = 9;

        /// <summary>
        /// Floats of an element, in m2/m2: the products SS, PP, SP, SSPP of <see cref="FacetPower"/>, then SSSP and
        /// PPSP over the sine of twice the angle to the wind; sigma0 of breaking waves, whose row is over the incidence
        /// on the mean sea, in the first column that of VV and HH, in the others that of HV; and the power of the wind with
        /// which Bragg scattering of the facet itself grows.
        /// </summary>
        public const int Stride = 8;

        // Steps across the unresolved slopes, in standard deviations: the end and the width of one.
        const double LastSlope = 4;
        const int SlopeSteps = 24;

        // Samples over the cosine of the incidence, of what Bragg scattering needs.
        const int Samples = 2048;

        // Angle from the axes at which SSSP and PPSP are divided by a sine: they vanish on the axes themselves.
        const double OffAxis = 1e-3;

        // Cosine of the incidence at which breaking waves are taken for grazing incidence.
        const double GrazingCosine = 1e-3;

        readonly SeaScattering _scattering;
        readonly double2 _slopeVariance;
        readonly WaveDensity _windExponent;
        readonly BraggSample[] _samples = new BraggSample[Samples + 1];

        /// <summary>Computes the table.</summary>
        /// <param name="scattering">Frequency, permittivity and short waves.</param>
        /// <param name="resolved">Slope variance of the mesh's own waves, along and across the wind.</param>
        /// <param name="unresolved">
        /// The same of the waves from the facet's size to <see cref="SeaScattering.TiltCut"/>; 0 if the mesh carries
        /// all of them.
        /// </param>
        /// <param name="covariance">
        /// Of the unresolved slopes along and across the wind; Bragg scattering ignores it.
        /// </param>
        /// <param name="windExponent">Of a wave, <see cref="ShortWaves.WindExponent"/>; null: 0.</param>
        public FacetTable(SeaScattering scattering, in double2 resolved, in double2 unresolved, double covariance = 0,
            WaveDensity windExponent = null)
        {
            (_scattering, Unresolved, Covariance) = (scattering, unresolved, covariance);
            _windExponent = windExponent ?? ((waveNumber, cosine) => 0);
            // The slopes of waves add, but parts of a facet are tilted from the facet, and tilts add to more than
            // slopes. This keeps the variance of all slopes, to second order.
            _slopeVariance = unresolved / (1 + 4 * resolved + resolved.yx);
            for (int i = 0; i <= Samples; i++)
                _samples[i] = Sample((double)i / Samples);
            Values = new float[Rows * Columns * Stride];
            for (int row = 0; row < Rows; row++)
                for (int column = 0; column < Columns; column++)
                    Write(row, column);
        }

        /// <summary>
        /// Elements of <see cref="Stride"/> floats, column by column in each row: for a buffer of the device.
        /// </summary>
        public float[] Values { get; }

        /// <summary>Slope variance of the waves that the mesh leaves out, along and across the wind.</summary>
        public double2 Unresolved { get; }

        /// <summary>The same of tilts from the facet itself, which add to more than slopes.</summary>
        internal double2 TiltVariance => _slopeVariance;

        /// <summary>Covariance of these slopes.</summary>
        public double Covariance { get; }

        /// <summary>Power reflection of the mirror points.</summary>
        public double MirrorPower => _scattering.MirrorPower;

        /// <summary>
        /// Sigma0 of a facet per its true area, Bragg scattering by bilinear interpolation; 0 from behind.
        /// </summary>
        /// <param name="normal">Of the facet.</param>
        /// <param name="toRadar">Towards the radar.</param>
        /// <param name="wind">Horizontal, along the wind.</param>
        /// <param name="logWind">Of <see cref="SeaClutter.LogWinds"/>.</param>
        public Sigma0 Read(in double3 normal, in double3 toRadar, in double3 wind, double logWind = 0)
        {
            var view = new FacetView(normal, toRadar, wind);
            if (!(view.Cosine > 0))
                return default;
            double row = (Rows - 1) * Math.Sqrt(Math.Max(0, 1 - view.Cosine));
            double column = (Columns - 1) * view.WindSine * view.WindSine;
            int top = Math.Min((int)row, Rows - 2), left = Math.Min((int)column, Columns - 2);
            double down = row - top, right = column - left;
            int at = (top * Columns + left) * Stride;
            double Value(int i) =>
                (1 - down) * ((1 - right) * Values[at + i] + right * Values[at + Stride + i])
                + down * ((1 - right) * Values[at + Columns * Stride + i]
                    + right * Values[at + (Columns + 1) * Stride + i]);
            double twice = 2 * view.WindSine * view.WindCosine;
            double specular = _scattering.Specular(normal, toRadar, wind, Unresolved, Covariance);
            return Math.Exp(Value(7) * logWind) * new FacetPower(Value(0), Value(1), Value(2), Value(3),
                twice * Value(4), twice * Value(5)).Seen(view.TurnCosine, view.TurnSine) + new Sigma0(specular, specular, 0);
        }

        void Write(int row, int column)
        {
            double root = (double)row / (Rows - 1), cosine = 1 - root * root;
            double angle = Math.Asin(Math.Sqrt((double)column / (Columns - 1)));
            angle = Math.Max(OffAxis, Math.Min(Math.PI / 2 - OffAxis, angle));
            double windCosine = Math.Cos(angle), windSine = Math.Sin(angle), twice = Math.Sin(2 * angle);
            double sine = Math.Sqrt(1 - cosine * cosine);
            var power = Mean(cosine, sine, windCosine, windSine);
            int at = (row * Columns + column) * Stride;
            var values = new[] { power.SS, power.PP, power.SP, power.SSPP, power.SSSP / twice, power.PPSP / twice,
                column == 0 ? SeaScattering.Breaking(Math.Max(GrazingCosine, cosine)) : _scattering.BreakingCross(cosine),
                _windExponent(_scattering.BraggWaveNumber(sine), windCosine) };
            for (int i = 0; i < values.Length; i++)
                Values[at + i] = (float)values[i];
        }

        // In the facet's frame: x towards the radar, y along s, z the normal.
        FacetPower Mean(double cosine, double sine, double windCosine, double windSine)
        {
            double along = Math.Sqrt(_slopeVariance.x), across = Math.Sqrt(_slopeVariance.y);
            int steps = along > 0 || across > 0 ? SlopeSteps : 0;
            var sum = default(FacetPower);
            double weights = 0;
            for (int i = 0; i <= steps; i++)
                for (int j = 0; j <= steps; j++)
                {
                    double u = Deviation(i, steps), v = Deviation(j, steps), weight = Math.Exp(-(u * u + v * v) / 2);
                    double slopeU = u * along, slopeV = v * across;
                    sum += Tilted(cosine, sine, slopeU * windCosine - slopeV * windSine,
                        slopeU * windSine + slopeV * windCosine, windCosine, windSine, weight);
                    weights += weight;
                }
            return sum.Scaled(1 / weights);
        }

        // A part of the facet with a slope of its own.
        FacetPower Tilted(double cosine, double sine, double slopeX, double slopeY, double windCosine,
            double windSine, double weight)
        {
            double length = Math.Sqrt(1 + slopeX * slopeX + slopeY * slopeY);
            double tilted = (cosine + slopeX * sine) / length;
            double tiltedSine = Math.Sqrt(Math.Max(0, 1 - tilted * tilted));
            if (!_scattering.HasBragg(tilted, tiltedSine))
                return default;
            // Normal x direction to the radar, of the part; the facet's second vector is (-cosine, 0, sine).
            double x = slopeY * cosine, y = sine - slopeX * cosine, z = -slopeY * sine;
            double scale = 1 / (length * tiltedSine);
            // Towards the radar in the part's plane, as seen along the facet's normal.
            double towardsX = sine - tilted * slopeX / length, towardsY = -tilted * slopeY / length;
            double flat = towardsX * towardsX + towardsY * towardsY;
            double projected = towardsX * windCosine + towardsY * windSine;
            double squaredCosine = flat > 0 ? projected * projected / flat : 1;
            double at = tilted * Samples;
            int below = Math.Min((int)at, Samples - 1);
            var sample = BraggSample.Between(_samples[below], _samples[below + 1], at - below);
            return FacetPower.OfTilted(sample.HH, sample.VV, weight * sample.Power(squaredCosine), y * scale,
                (z * sine - x * cosine) * scale);
        }

        BraggSample Sample(double cosine)
        {
            double sine = Math.Sqrt(1 - cosine * cosine);
            var (hh, vv) = _scattering.Coefficients(cosine);
            return new BraggSample(hh, vv, _scattering.BraggPower(cosine, sine, 0),
                _scattering.BraggPower(cosine, sine, Math.Sqrt(0.5)), _scattering.BraggPower(cosine, sine, 1));
        }

        static double Deviation(int step, int steps) => steps == 0 ? 0 : LastSlope * (2.0 * step / steps - 1);

        // Coefficients and power at one incidence. The power is quadratic in the squared cosine to the wind: across,
        // between and along it; for a spectrum with a second harmonic of the angle that is exact.
        readonly struct BraggSample
        {
            public readonly Complex HH, VV;
            readonly double _across, _between, _along;

            public BraggSample(Complex hh, Complex vv, double across, double between, double along) =>
                (HH, VV, _across, _between, _along) = (hh, vv, across, between, along);

            public static BraggSample Between(in BraggSample a, in BraggSample b, double share) =>
                new BraggSample(a.HH + share * (b.HH - a.HH), a.VV + share * (b.VV - a.VV),
                    a._across + share * (b._across - a._across), a._between + share * (b._between - a._between),
                    a._along + share * (b._along - a._along));

            public double Power(double squaredCosine)
            {
                double x = 2 * squaredCosine - 1;
                return _between + x * (_along - _across) / 2 + x * x * ((_along + _across) / 2 - _between);
            }
        }
    }
}
