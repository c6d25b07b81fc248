using System;

namespace Glint.Core
{
    /// <summary>
    /// Gusts over a tile of sea: the turbulence of the wind 10 m above it, which the wind carries along unchanged.
    /// Along the wind its spectrum is that of Kaimal, Wyngaard, Izumi and Cote (1972) in neutral air; across the wind
    /// its parts decorrelate exponentially (IEC 61400-1, annex B). Gusts repeat with the tile.
    /// </summary>
    readonly struct Gusts
    {
        /// <summary>
        /// Standard deviation of the wind over its friction velocity u*: the root of 105 / 22, which is the integral of
        /// n S / u*^2 = 105 f / (1 + 33 f)^(5/3), f = n z / U, over ln n.
        /// </summary>
        public const double DefaultGustiness = 2.18;

        /// <summary>
        /// Gustiness: 2.2 to 2.4 is published of neutral air, and up to 4 of a sea much warmer than the air.
        /// </summary>
        public static readonly Interval Gustinesses = Interval.Closed(0, 4);

        // Metres above the sea. Shorter gusts are left out: they pass before ripples respond, in about a second.
        const double Height = 10;

        // Of the coherence exp(-12 sqrt((n r / U)^2 + (0.12 r / L)^2)) at a distance r across the wind, with the length
        // L = 8.1 * 0.7 z.
        const double Decay = 12, MinDecay = 0.12 / (8.1 * 0.7 * Height);

        readonly double _wind, _deviation;

        /// <summary>The gusts of a wind.</summary>
        /// <param name="wind">10 m above the sea, m/s.</param>
        /// <param name="gustiness">Standard deviation over the friction velocity.</param>
        public Gusts(double wind, double gustiness) =>
            (_wind, _deviation) = (wind, gustiness * Elfouhaily.FrictionVelocity(wind) / wind);

        /// <summary>
        /// Natural logarithm of the wind over its mean at the first corner of each cell of a tile, row by row. The mean
        /// of the wind itself stays, over many tiles.
        /// </summary>
        /// <param name="sea">The tile.</param>
        /// <param name="seed">Of the gusts.</param>
        /// <param name="time">Seconds.</param>
        public double[] LogWinds(SeaSurface sea, uint seed, double time)
        {
            var waves = new WaveCoefficients(sea.Reach);
            var (windX, windZ) = PortableMath.SinCos(sea.Settings.WindDirectionDegrees / 360);
            double step = 2 * Math.PI / sea.Settings.TileSize, shortest = 2 * Math.PI / Height, variance = 0;
            // Other numbers than those of the waves of the same seed.
            ulong stream = new SplitMix64(~(ulong)seed).Next();
            for (int row = 0; row <= sea.Reach; row++)
                for (int column = row == 0 ? 1 : -sea.Reach; column <= sea.Reach; column++)
                {
                    double along = step * (column * windX + row * windZ),
                        across = step * (column * windZ - row * windX);
                    if (along * along + across * across > shortest * shortest)
                        continue;
                    // Of the wave and its opposite.
                    double power = 2 * _deviation * _deviation * Share(along, across, step);
                    variance += power;
                    var random = new SplitMix64(new SplitMix64(stream + ((ulong)(uint)column << 32 | (uint)row)).Next());
                    double size = Math.Sqrt(-power / 2 * Math.Log(random.NextAboveZero()));
                    var (sine, cosine) =
                        PortableMath.SinCos(random.NextAboveZero() - along * _wind * time / (2 * Math.PI));
                    int at = waves.IndexOf(column, row);
                    (waves.Real[at], waves.Imaginary[at]) = (size * cosine, size * sine);
                }
            double[] winds = sea.AtCells(waves);
            for (int cell = 0; cell < winds.Length; cell++)
                winds[cell] -= variance / 2;
            return winds;
        }

        // Of the variance, in the square of a step around a wave, rad/m: Kaimal's spectrum along the wind, and the Fourier
        // transform of the coherence across it.
        static double Share(double along, double across, double step)
        {
            double perRadian = Height / (2 * Math.PI), turns = Math.Abs(along) / (2 * Math.PI),
                decay = Decay * Math.Sqrt(turns * turns + MinDecay * MinDecay);
            return step * 11 * perRadian / Math.Pow(1 + 33 * Height * turns, 5.0 / 3)
                * (Math.Atan((across + step / 2) / decay) - Math.Atan((across - step / 2) / decay)) / Math.PI;
        }
    }
}
