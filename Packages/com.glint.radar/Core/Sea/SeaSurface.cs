using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// A sea's tile at any time: waves of random amplitude and phase (Tessendorf, Simulating Ocean Water, 2001),
    /// travelling with the wind or the swell at the speed of deep-water waves. No wave meets its opposite, so the
    /// variance over the tile is constant in time. It differs between seeds, more so if the tile holds few waves.
    /// </summary>
    public sealed class SeaSurface
    {
        // Metres: stored coordinates are multiples of it, or of a coarser step where float32 is coarser.
        const double FinestStep = 1.0 / 65536;

        // At later times the rounding of the phase exceeds the error of the sine.
        const double LongestTime = 1e7;

        readonly SeaSettings _settings;
        readonly SeaMode[] _modes;
        readonly IWaveSum _sum;
        readonly int _reach;
        readonly int[] _indices;
        readonly ulong _seed;

        /// <summary>Draws the amplitudes.</summary>
        /// <exception cref="GlintException">
        /// A setting is out of its range, or the spectrum has no wave that the tile's grid holds.
        /// </exception>
        public SeaSurface(SeaSettings settings) : this(settings, null)
        {
        }

        SeaSurface(SeaSettings settings, SeaSurface coarser)
        {
            settings.Validate();
            _settings = settings;
            // A wave of two grid points has no direction: the grid's last row and column are empty.
            _reach = settings.GridSize / 2 - 1;
            _seed = new SplitMix64(coarser == null ? (ulong)settings.Seed : coarser._seed).Next();
            _modes = Draw(coarser, out double expected, out double scale);
            DensityScale = scale;
            SignificantWaveHeight = 4 * Math.Sqrt(expected);
            bool isFast = settings.Cells >= settings.GridSize && (settings.Cells & (settings.Cells - 1)) == 0;
            _sum = isFast ? (IWaveSum)new FourierSum(settings.Cells) : new TrigonometricSum(settings.Cells, _reach);
            _indices = MakeIndices(settings.Cells);
        }

        /// <summary>Settings of the sea.</summary>
        public SeaSettings Settings => _settings;

        /// <summary>
        /// Hs of the spectrum, metres, the mean over seeds: the requested Hs times the height factor. If none is
        /// requested, that of the waves of the wind that the tile holds. Swell adds the square of its height times the
        /// height factor. A <see cref="Finer"/> tile has the height of its own waves.
        /// </summary>
        public double SignificantWaveHeight { get; }

        /// <summary>
        /// Factor from <see cref="SeaSpectrum.Density"/> to the density of the tile's waves of the wind.
        /// </summary>
        internal double DensityScale { get; }

        internal IReadOnlyList<SeaMode> Modes => _modes;

        /// <summary>Largest column and row of its waves.</summary>
        internal int Reach => _reach;

        /// <summary>A field of waves up to <see cref="Reach"/>, at the first corner of each cell.</summary>
        internal double[] AtCells(WaveCoefficients waves) => _sum.Sum(waves);

        // Metres along x or z: shorter waves are those of a finer tile.
        double ShortestLength => _settings.TileSize / (_reach + 0.5);

        /// <summary>Vertices of the triangles of <see cref="Mesh"/>, which are the same at any time.</summary>
        internal IReadOnlyList<int> Indices => _indices;

        /// <summary>
        /// Hs of this sea, metres: four standard deviations of the height over the tile.
        /// </summary>
        public double MeasuredWaveHeight(double timeSeconds) => 4 * Math.Sqrt(Variance(timeSeconds));

        /// <summary>
        /// A smaller tile of the same sea, with as many grid points: the waves that are too short for the grid of this
        /// tile, of the same density, with random numbers of their own. The heights of both add up to the sea.
        /// </summary>
        /// <param name="tileSize">Side in metres.</param>
        /// <exception cref="GlintException">
        /// The size is out of its range or not smaller, or the sea has no shorter waves.
        /// </exception>
        public SeaSurface Finer(double tileSize)
        {
            if (!(tileSize < _settings.TileSize))
                throw new GlintException($"sea: the finer tile of {RadarSettings.Text(tileSize)} m must be smaller "
                    + $"than the tile of {RadarSettings.Text(_settings.TileSize)} m, whose shorter waves it holds");
            var settings = _settings;
            // The grid of the larger tile holds the whole swell.
            (settings.TileSize, settings.Cells, settings.SwellHeight) = (tileSize, settings.GridSize, 0);
            return new SeaSurface(settings, this);
        }

        /// <summary>The tile's waves with the phases that they have at a time.</summary>
        /// <exception cref="GlintException">The time is not finite, or too far from 0.</exception>
        public SeaMode[] ModesAt(double timeSeconds)
        {
            CheckTime(timeSeconds);
            var modes = (SeaMode[])_modes.Clone();
            for (int i = 0; i < modes.Length; i++)
            {
                var mode = _modes[i];
                var (sine, cosine) = PortableMath.SinCos(-mode.Frequency * timeSeconds);
                modes[i].Real = mode.Real * cosine - mode.Imaginary * sine;
                modes[i].Imaginary = mode.Real * sine + mode.Imaginary * cosine;
            }
            return modes;
        }

        /// <summary>Refuses a time at which the phases of waves are not known well enough.</summary>
        /// <exception cref="GlintException">The time is not finite, or too far from 0.</exception>
        public static void CheckTime(double timeSeconds)
        {
            if (!(Math.Abs(timeSeconds) <= LongestTime))
                throw new GlintException($"sea: time {RadarSettings.Text(timeSeconds)} s must be within "
                    + $"{RadarSettings.Text(LongestTime)} s of 0");
        }

        /// <summary>
        /// The height factor with which Hs over all these times (four times the root of the mean variance) is the
        /// requested one, swell included. 1 if none is requested: the waves then keep the density of their spectrum.
        /// </summary>
        /// <exception cref="GlintException">A setting is out of its range, or there are no times.</exception>
        public static double FactorFor(SeaSettings settings, IReadOnlyCollection<double> times)
        {
            if (times.Count == 0)
                throw new GlintException("sea: the height factor needs at least one time");
            settings.HeightFactor = 1;
            if (settings.SignificantWaveHeight == 0)
                return 1;
            var surface = new SeaSurface(settings);
            double sum = 0;
            foreach (double time in times)
                sum += surface.Variance(time);
            double asked = settings.SwellHeight > 0 ? surface.SignificantWaveHeight : settings.SignificantWaveHeight;
            return asked / (4 * Math.Sqrt(sum / times.Count));
        }

        /// <summary>
        /// The tile at a time, centred on the origin: x and z from half its size below 0 to half above,
        /// y up with mean 0, displaced sideways by the choppiness.
        /// Opposite edges differ by exactly the tile's size.
        /// </summary>
        /// <exception cref="GlintException">The time is not finite, or too far from 0.</exception>
        public TriangleMesh Mesh(double timeSeconds)
        {
            var waves = At(timeSeconds);
            double[] height = _sum.Sum(waves), alongX = null, alongZ = null;
            if (_settings.Choppiness > 0)
            {
                alongX = _sum.Sum(Displacement(waves, mode => mode.AlongX));
                alongZ = _sum.Sum(Displacement(waves, mode => mode.AlongZ));
            }

            int cells = _settings.Cells, side = cells + 1;
            double tile = _settings.TileSize, step = Step(tile);
            var vertices = new float3[side * side];
            for (int z = 0; z < side; z++)
                for (int x = 0; x < side; x++)
                {
                    // The last row and column are copies of the first, displaced by a tile, so that they agree bit for
                    // bit.
                    int column = x % cells, row = z % cells, at = row * cells + column;
                    double positionX =
                        Rounded(tile * ((double)column / cells - 0.5) + (alongX == null ? 0 : alongX[at]), step);
                    double positionZ =
                        Rounded(tile * ((double)row / cells - 0.5) + (alongZ == null ? 0 : alongZ[at]), step);
                    vertices[z * side + x] = new float3(
                        (float)(x == cells ? positionX + tile : positionX), (float)Rounded(height[at], FinestStep),
                        (float)(z == cells ? positionZ + tile : positionZ));
                }
            return new TriangleMesh(vertices, _indices);
        }

        /// <summary>
        /// Upward acceleration in m/s2 of the linear waves at the vertices of <see cref="Mesh"/>, in their order.
        /// </summary>
        /// <exception cref="GlintException">The time is not finite, or too far from 0.</exception>
        public double[] Accelerations(double timeSeconds)
        {
            var waves = At(timeSeconds);
            foreach (var mode in _modes)
            {
                int at = waves.IndexOf(mode.Column, mode.Row);
                double frequency = 2 * Math.PI * mode.Frequency, factor = -frequency * frequency;
                waves.Real[at] *= factor;
                waves.Imaginary[at] *= factor;
            }
            return AtVertices(_sum.Sum(waves));
        }

        /// <summary>
        /// Velocity in m/s of the water of the linear waves at the vertices of <see cref="Mesh"/>, in their order.
        /// Water moves along a wave as fast as up and down: forward on crests.
        /// </summary>
        /// <exception cref="GlintException">The time is not finite, or too far from 0.</exception>
        public double3[] Velocities(double timeSeconds)
        {
            var waves = At(timeSeconds);
            double[] Part(Func<SeaMode, double> real, Func<SeaMode, double> imaginary)
            {
                var part = new WaveCoefficients(_reach);
                foreach (var mode in _modes)
                {
                    int at = waves.IndexOf(mode.Column, mode.Row);
                    double frequency = 2 * Math.PI * mode.Frequency, a = frequency * real(mode),
                        b = frequency * imaginary(mode);
                    part.Real[at] = a * waves.Real[at] - b * waves.Imaginary[at];
                    part.Imaginary[at] = a * waves.Imaginary[at] + b * waves.Real[at];
                }
                return AtVertices(_sum.Sum(part));
            }

            // The height turns as e^(-i w t).
            double[] x = Part(mode => mode.AlongX, _ => 0), y = Part(_ => 0, _ => -1),
                z = Part(mode => mode.AlongZ, _ => 0);
            return Enumerable.Range(0, x.Length).Select(i => new double3(x[i], y[i], z[i])).ToArray();
        }

        double[] AtVertices(double[] ofCells)
        {
            int cells = _settings.Cells, side = cells + 1;
            var ofVertices = new double[side * side];
            for (int i = 0; i < ofVertices.Length; i++)
                ofVertices[i] = ofCells[i / side % cells * cells + i % side % cells];
            return ofVertices;
        }

        /// <summary>
        /// Mean square slopes along and across the wind of the tile's linear waves up to a wave number in rad/m. They
        /// are the same at any time.
        /// </summary>
        public double2 SlopeVariances(double to)
        {
            var (windX, windZ) = PortableMath.SinCos(_settings.WindDirectionDegrees / 360);
            double number = 2 * Math.PI / _settings.TileSize;
            double2 sum = 0;
            foreach (var mode in _modes)
            {
                double k = number * Math.Sqrt((double)mode.Column * mode.Column + (double)mode.Row * mode.Row);
                if (k > to)
                    continue;
                double cosine = mode.AlongX * windX + mode.AlongZ * windZ,
                    sine = mode.AlongX * windZ - mode.AlongZ * windX;
                double height = 2 * (mode.Real * mode.Real + mode.Imaginary * mode.Imaginary);
                sum += height * k * k * new double2(cosine * cosine, sine * sine);
            }
            return sum;
        }

        /// <summary>
        /// Mean square slopes along and across the wind of the facets of <see cref="Mesh"/>, at any time and without
        /// choppiness, and their covariance. A facet cuts off the crests of waves that are not much longer than itself:
        /// its slopes are those of chords, and fall least along the diagonals that divide the cells.
        /// </summary>
        public (double2 Variances, double Covariance) FacetSlopeVariances()
        {
            var (windX, windZ) = PortableMath.SinCos(_settings.WindDirectionDegrees / 360);
            double side = _settings.TileSize / _settings.Cells, halfTurns = 0.5 / _settings.Cells;
            double2 sum = 0;
            double covariance = 0;
            foreach (var mode in _modes)
            {
                double x = 2 * PortableMath.SinCos(mode.Column * halfTurns).Sine / side,
                    z = 2 * PortableMath.SinCos(mode.Row * halfTurns).Sine / side;
                // Chords along X and Z begin at one corner; their middles are apart.
                double product = x * z * PortableMath.SinCos((mode.Column - mode.Row) * halfTurns).Cosine,
                    both = 2 * windX * windZ * product;
                double height = 2 * (mode.Real * mode.Real + mode.Imaginary * mode.Imaginary);
                (double xx, double zz) = (x * x, z * z);
                sum += height * new double2(windX * windX * xx + windZ * windZ * zz + both,
                    windZ * windZ * xx + windX * windX * zz - both);
                covariance += height * (windX * windZ * (xx - zz) + (windZ * windZ - windX * windX) * product);
            }
            return (sum, covariance);
        }

        // The scale is that from the density of the spectrum to that of the waves of the wind.
        SeaMode[] Draw(SeaSurface coarser, out double expected, out double densityScale)
        {
            var settings = _settings;
            double number = 2 * Math.PI / settings.TileSize;
            var modes = new List<SeaMode>();
            var variances = new List<double>();
            double sum = ListWindSea(coarser, modes, variances);
            if (!(sum > 1e-200))
                throw new GlintException($"sea: the wind of {RadarSettings.Text(settings.WindSpeed)} m/s raises no "
                    + $"wave between {RadarSettings.Text(settings.TileSize / _reach)} and "
                    + $"{RadarSettings.Text(coarser == null ? settings.TileSize : coarser.ShortestLength)} m, "
                    + "which are those that the grid holds: give it more wind, a smaller tile or a larger grid");

            double asked = settings.SignificantWaveHeight * settings.HeightFactor / 4, area = number * number,
                scale = coarser != null ? coarser.DensityScale * area
                    : asked > 0 ? asked * asked / sum : settings.HeightFactor * settings.HeightFactor * area;
            densityScale = scale / area;
            for (int i = 0; i < modes.Count; i++)
                variances[i] *= scale;
            if (settings.SwellHeight > 0)
                AddSwell(modes, variances);
            var drawn = modes.ToArray();
            expected = 0;
            for (int i = 0; i < drawn.Length; i++)
            {
                // A wave 2 Re(h e^...) has the variance 2 |h|^2, and |h|^2 is 2 on average as drawn.
                double variance = variances[i], amplitude = Math.Sqrt(variance / 4);
                drawn[i].Real *= amplitude;
                drawn[i].Imaginary *= amplitude;
                expected += variance;
            }
            return drawn;
        }

        // The waves of the wind, their variances without scale, and the sum of these.
        double ListWindSea(SeaSurface coarser, List<SeaMode> modes, List<double> variances)
        {
            var settings = _settings;
            double number = 2 * Math.PI / settings.TileSize, sum = 0;
            var (windX, windZ) = PortableMath.SinCos(settings.WindDirectionDegrees / 360);
            for (int row = -_reach; row <= _reach; row++)
                for (int column = -_reach; column <= _reach; column++)
                {
                    if (row == 0 && column == 0)
                        continue;
                    double length = Math.Sqrt((double)row * row + (double)column * column);
                    double cosine = (column * windX + row * windZ) / length;
                    // A wave across the wind and its opposite are one mode.
                    if (cosine == 0 && !IsMode(column, row))
                        continue;
                    double variance = SeaSpectrum.Density(settings, number * length, cosine)
                        * ShareBeyond(coarser, column, row);
                    if (!(variance > 0))
                        continue;
                    sum += variance;
                    variances.Add(variance);
                    modes.Add(MakeMode(settings.Kind, column, row, length, number, _seed));
                }
            return sum;
        }

        // Of a wave and its opposite the tile holds one, so that the variance stays constant in time: the higher one,
        // with the variance of both.
        void AddSwell(List<SeaMode> modes, List<double> variances)
        {
            double number = 2 * Math.PI / _settings.TileSize;
            var swell = new Swell(_settings).Variances(_reach).Select(wave =>
                (Mode: MakeMode(_settings.Kind, wave.Column, wave.Row, Math.Sqrt((double)wave.Row * wave.Row
                    + (double)wave.Column * wave.Column), number, _seed), wave.Variance))
                .ToDictionary(wave => (wave.Mode.Column, wave.Mode.Row));
            for (int i = 0; i < modes.Count; i++)
            {
                if (!swell.TryGetValue((modes[i].Column, modes[i].Row), out var wave))
                    continue;
                if (wave.Variance > variances[i])
                    modes[i] = wave.Mode;
                variances[i] += wave.Variance;
                swell.Remove((modes[i].Column, modes[i].Row));
            }
            modes.AddRange(swell.Values.Select(wave => wave.Mode));
            variances.AddRange(swell.Values.Select(wave => wave.Variance));
        }

        // A wave stands for the square of wave numbers around it. The share of it that a larger tile's grid leaves.
        double ShareBeyond(SeaSurface coarser, int column, int row)
        {
            if (coarser == null)
                return 1;
            double end = _settings.TileSize / coarser.ShortestLength;
            double Inside(int number)
            {
                double inside = end + 0.5 - Math.Abs(number);
                return inside < 0 ? 0 : inside > 1 ? 1 : inside;
            }
            return 1 - Inside(column) * Inside(row);
        }

        // Normally distributed real and imaginary part of variance 1 each, by Box and Muller.
        // The random number depends on the wave alone, not on grid or order.
        static SeaMode MakeMode(SeaSpectrumKind kind, int column, int row, double length, double number, ulong seed)
        {
            var random = new SplitMix64(new SplitMix64(seed + ((ulong)(uint)column << 32 | (uint)row)).Next());
            double radius = Math.Sqrt(-2 * PortableMath.Log(random.NextAboveZero()));
            var (sine, cosine) = PortableMath.SinCos(random.NextAboveZero());
            int sign = IsMode(column, row) ? 1 : -1;
            return new SeaMode
            {
                Column = sign * column, Row = sign * row, Real = radius * cosine, Imaginary = sign * radius * sine,
                Frequency = sign * SeaSpectrum.AngularFrequency(kind, number * length) / (2 * Math.PI),
                AlongX = sign * column / length, AlongZ = sign * row / length,
            };
        }

        // Whether a SeaMode has this column and row, rather than their opposites.
        static bool IsMode(int column, int row) => row > 0 || row == 0 && column > 0;

        WaveCoefficients At(double time)
        {
            var waves = new WaveCoefficients(_reach);
            foreach (var mode in ModesAt(time))
            {
                int at = waves.IndexOf(mode.Column, mode.Row);
                (waves.Real[at], waves.Imaginary[at]) = (mode.Real, mode.Imaginary);
            }
            return waves;
        }

        // i k / |k| times the height: towards the crests.
        WaveCoefficients Displacement(WaveCoefficients height, Func<SeaMode, double> along)
        {
            var waves = new WaveCoefficients(_reach);
            foreach (var mode in _modes)
            {
                int at = waves.IndexOf(mode.Column, mode.Row);
                double factor = _settings.Choppiness * along(mode);
                waves.Real[at] = -factor * height.Imaginary[at];
                waves.Imaginary[at] = factor * height.Real[at];
            }
            return waves;
        }

        double Variance(double time)
        {
            var waves = At(time);
            double sum = 0;
            for (int i = 0; i < waves.Real.Length; i++)
                sum += waves.Real[i] * waves.Real[i] + waves.Imaginary[i] * waves.Imaginary[i];
            return 2 * sum;
        }

        // Clockwise seen from above, which is Unity's front.
        static int[] MakeIndices(int cells)
        {
            var indices = new int[6 * cells * cells];
            int at = 0, side = cells + 1;
            for (int z = 0; z < cells; z++)
                for (int x = 0; x < cells; x++)
                {
                    int corner = z * side + x;
                    indices[at++] = corner;
                    indices[at++] = corner + side;
                    indices[at++] = corner + 1;
                    indices[at++] = corner + 1;
                    indices[at++] = corner + side;
                    indices[at++] = corner + side + 1;
                }
            return indices;
        }

        // float32 has 24 bits, and no coordinate exceeds the tile's size.
        static double Step(double tile)
        {
            double step = FinestStep;
            while (tile > step * (1 << 24))
                step *= 2;
            return step;
        }

        // System.Math rounds differently between runtimes just below a half.
        static double Rounded(double value, double step) => Math.Floor(value / step + 0.5) * step;
    }

    /// <summary>
    /// One wave of a sea's tile. Its height is 2 Re(h e^(i(2 pi (Column x + Row z) / tile - w t))),
    /// x and z from the tile's corner.
    /// </summary>
    public struct SeaMode
    {
        /// <summary>
        /// Waves a tile along x and z; of each pair k and -k, which are the same wave,
        /// the one with z above 0, or z 0 and x above 0.
        /// </summary>
        public int Column, Row;

        /// <summary>h, metres.</summary>
        public double Real, Imaginary;

        /// <summary>w over 2 pi, turns a second: negative if the wave travels along -k.</summary>
        public double Frequency;

        /// <summary>k over its length.</summary>
        public double AlongX, AlongZ;
    }
}
