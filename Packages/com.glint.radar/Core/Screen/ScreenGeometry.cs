using System;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Spokes and range cells of a turn, what the beam and the pulse make of an echo, and the level of echoes. Spoke n
    /// lies at n / <see cref="ScreenRadar.Spokes"/> turns clockwise from north, cell n begins at n times
    /// <see cref="CellSize"/>. Immutable.
    /// </summary>
    public sealed class ScreenGeometry
    {
        /// <summary>
        /// Units of a sum of echoes in the root of the noise's power: ECHO_UNITS in Shaders/Screen.hlsl. 32 bits hold
        /// 85 echoes of up to 112 dB over noise in a cell; roundings are 36 dB below it.
        /// </summary>
        public const double UnitsOfNoise = 64;

        /// <summary>Smallest weight of a spoke in the beam: the square is 80 dB down.</summary>
        public const double SmallestWeight = 1e-4;

        /// <summary>Steps of <see cref="Elevation"/>: ELEVATION_STEPS in Shaders/ScreenPattern.hlsl.</summary>
        public const int ElevationSteps = 4096;

        // |K|^2 of water.
        const double WaterFactor = 0.93;

        readonly RadarEquation _equation;
        readonly AntennaPattern _elevation;
        readonly double _waveNumber;

        /// <param name="table">Text of the pattern's table: <see cref="EchoAntenna.TableHeader"/>.</param>
        /// <exception cref="GlintException">A setting is out of its range, or the table is none.</exception>
        public ScreenGeometry(in ScreenRadar radar, string subject, string table = null)
        {
            radar.Validate(subject);
            Radar = radar;
            var pattern = PatternOf(radar, subject, table);
            radar.RequireSpokes(subject, pattern.Azimuth.Width);
            CellSize = radar.RangeScale / radar.Cells;
            double pulse = 1e-9 * radar.PulseNanoseconds;
            NoisePower = new ThermalNoise(radar.Seed, 1 / pulse, radar.NoiseFigureDb).Power;
            Units = UnitsOfNoise / Math.Sqrt(NoisePower);
            _equation = new RadarEquation(radar.Power, radar.Frequency, radar.LossDb);
            BeamWidth = pattern.Azimuth.Width;
            _elevation = pattern.Elevation;
            Antenna = new Antenna(pattern.UsualGainDb, pattern.Azimuth, _elevation);
            _waveNumber = 2 * Math.PI / Signal.Wavelength(radar.Frequency);
            Beam = BeamOf(pattern.Azimuth, radar.Spokes);
            Elevation = Enumerable.Range(0, ElevationSteps + 1).Select(step =>
                (float)_elevation.Field(Math.PI * ((double)step / ElevationSteps - 0.5)).Real).ToArray();
            PulseLength = Signal.SpeedOfLight / 2 * pulse;
            Pulse = Enumerable.Range(0, radar.Cells).Select(cell => 1 - cell * CellSize / PulseLength)
                .TakeWhile((weight, cell) => cell == 0 || weight > 0).Select(weight => (float)weight).ToArray();
            NoiseGain = 1 / (1 + 2 * Pulse.Skip(1).Sum(weight => (double)weight * weight));
            FillFactor = Math.Sqrt(2.0 / 3 * PulseLength / CellSize * NoiseGain);
            AmplitudeAtOne = Amplitude(1, 1, 1);
            RainAmplitude = RainOf(radar);
            RainLoss = Math.Log(10) / 20 / 1000 * RainAttenuation.DecibelsAKilometre(radar.Frequency, radar.RainRate,
                radar.Polarisation == ScreenPolarisation.Horizontal);
        }

        /// <summary>The settings.</summary>
        public ScreenRadar Radar { get; }

        /// <summary>Metres from one cell to the next.</summary>
        public double CellSize { get; }

        /// <summary>Half of the length of a pulse in metres, by which it blurs ranges.</summary>
        public double PulseLength { get; }

        /// <summary>Mean power of the noise, watts.</summary>
        public double NoisePower { get; }

        /// <summary>Units of the sums of echoes a root watt.</summary>
        public double Units { get; }

        /// <summary>Half-power width of the beam, degrees.</summary>
        public double BeamWidth { get; }

        /// <summary>Gain and pattern.</summary>
        public Antenna Antenna { get; }

        /// <summary>
        /// Weights of the echoes of <see cref="HalfBeam"/> spokes to the left of a spoke, of its own and of as many to the
        /// right in its signal: the field of the pattern out and back.
        /// </summary>
        public float[] Beam { get; }

        /// <summary>
        /// The pattern's field one way at <see cref="ElevationSteps"/> equal steps of elevation, from straight down to
        /// straight up.
        /// </summary>
        public float[] Elevation { get; }

        /// <summary>
        /// Weight of the echo of a cell in the signal of another, by their distance in cells: the pulse behind its
        /// matched filter, a triangle.
        /// </summary>
        public float[] Pulse { get; }

        /// <summary>Spokes on each side of a spoke whose echoes are part of its signal.</summary>
        public int HalfBeam => Beam.Length / 2;

        /// <summary>Mean power of the noise of the sums before the pulse's weights, over that behind them.</summary>
        public double NoiseGain { get; }

        /// <summary>
        /// Factor of the amplitude of echoes that fill their cells, as of sea and rain: the square of the pulse's
        /// triangle has 2/3 of its half base, and the sum over its weights differs from that where cells are long.
        /// </summary>
        public double FillFactor { get; }

        /// <summary>
        /// Amplitude in units of an echo of one square metre at one metre, where the pattern is 1: without
        /// <see cref="Beam"/> and <see cref="Elevation"/>.
        /// </summary>
        public double AmplitudeAtOne { get; }

        /// <summary>
        /// Root of the power of the rain's echo in a spoke, in units, times the range in cells. The drops are those of
        /// Marshall and Palmer, Z = 200 r^1.6 mm6/m3 at r mm/h, and scatter as Rayleigh's spheres.
        /// </summary>
        public double RainAmplitude { get; }

        /// <summary>A field falls in the rain with exp(-this way), the way one way in metres.</summary>
        public double RainLoss { get; }

        /// <summary>The spoke of an offset from the antenna, metres: x to the east, z to the north.</summary>
        public int SpokeOf(double3 offset) => SpokeOf(Math.Atan2(offset.x, offset.z) / (2 * Math.PI));

        /// <summary>The spoke of a bearing.</summary>
        /// <param name="turns">From north, any number of turns.</param>
        public int SpokeOf(double turns) =>
            InTurn((long)Math.Floor((turns - Math.Floor(turns)) * Radar.Spokes + 0.5));

        /// <summary>Place of a spoke in its turn.</summary>
        /// <param name="spoke">Counted from north in the first turn.</param>
        public int InTurn(long spoke) => (int)(spoke & (Radar.Spokes - 1));

        /// <summary>
        /// An echo as the sums take it. <see cref="ScreenPoint.Amplitude"/> is 0 behind the horizon and where the range
        /// at which it is shown is outside the range scale.
        /// </summary>
        /// <param name="position">Of the reflector, metres: x to the east, y above the sea, z to the north.</param>
        /// <param name="antenna">The same of the antenna.</param>
        /// <param name="section">Cross section, square metres.</param>
        public ScreenPoint PointOf(double3 position, double3 antenna, double section)
        {
            double3 way = position - antenna;
            double distance = math.length(way.xz), range = math.length(way);
            double shown = range % Radar.UnambiguousRange;
            if (!(section > 0 && section < double.PositiveInfinity) || !(range > 0 && shown < Radar.RangeScale)
                || IsBehindHorizon(antenna.y, position.y, distance))
                return default;
            var point = new ScreenPoint
            {
                Position = (float3)way, Cell = Math.Min((int)(shown / CellSize), Radar.Cells - 1),
                Spoke = SpokeOf(way)
            };
            double elevation = Math.Atan2(way.y - ClutterGeometry.DropAt(distance), distance),
                amplitude = Amplitude(section, range, _elevation.Field(elevation).Real) * Math.Exp(-2 * RainLoss * range)
                    * SeaFactor.Squared(antenna.y, position.y, distance, Radar.SeaReflection, _waveNumber);
            double phase = 2 * _waveNumber * range;
            point.Amplitude = (float)amplitude;
            point.Field = (float2)new double2(amplitude * Math.Cos(phase), amplitude * Math.Sin(phase));
            return point;
        }

        /// <summary>Level of a reflector in the middle of the beam in free space, dB over noise.</summary>
        /// <param name="section">Cross section, square metres.</param>
        /// <param name="range">Metres.</param>
        public double OverNoiseDb(double section, double range) => 20 * Math.Log10(
            Beam[HalfBeam] * Amplitude(section, range, Elevation[ElevationSteps / 2]) / UnitsOfNoise);

        /// <summary>Whether a smooth sea hides heights from each other.</summary>
        public static bool IsBehindHorizon(double height, double other, double distance) =>
            !(distance <= Horizon(height) + Horizon(other));

        static EchoAntenna PatternOf(in ScreenRadar radar, string subject, string table)
        {
            if (radar.Pattern == ScreenPattern.Table && string.IsNullOrEmpty(table))
                throw new GlintException($"{subject}: its pattern is that of a table, and there is none: give a Pattern "
                    + $"Table, a text whose first line is {EchoAntenna.TableHeader}, or choose another Pattern");
            try
            {
                return radar.Pattern == ScreenPattern.Table ? new EchoAntenna(table)
                    : new EchoAntenna(EchoAntenna.Names[(int)radar.Pattern],
                        new double2(radar.BeamWidth, radar.VerticalBeamWidth),
                        radar.Pattern == ScreenPattern.Cosecant
                            ? new double2(radar.CosecantFrom, radar.CosecantTo) : (double2?)null);
            }
            catch (Exception refusal) when (refusal is FormatException || refusal is GlintException)
            {
                throw new GlintException($"{subject}: {refusal.Message}", refusal);
            }
        }

        static float[] BeamOf(AntennaPattern azimuth, int spokes)
        {
            // More would come to the spokes of the turn before.
            int half = spokes / 4 - 1;
            double WeightOf(int spoke) => Math.Pow(azimuth.Field(2 * Math.PI * spoke / spokes).Real, 2);
            while (half > 0 && Math.Max(WeightOf(-half), WeightOf(half)) < SmallestWeight)
                half--;
            return Enumerable.Range(-half, 2 * half + 1).Select(spoke => (float)WeightOf(spoke)).ToArray();
        }

        double RainOf(in ScreenRadar radar)
        {
            // Section of a cubic metre, m2.
            double wave = Signal.Wavelength(radar.Frequency), z = 200 * Math.Pow(radar.RainRate, 1.6) * 1e-18,
                density = Math.Pow(Math.PI, 5) * WaterFactor * z / Math.Pow(wave, 4);
            // Of a spoke, with the power of the beam's height above the sea, out and back.
            double angle = 2 * Math.PI / radar.Spokes * Math.PI / ElevationSteps
                * Elevation.Skip(ElevationSteps / 2).Select((field, step) => (step == 0 ? 0.5 : 1) * Math.Pow(field, 4))
                    .Sum();
            // The volume is angle R^2 CellSize, and the amplitude falls with 1 / R^2.
            return FillFactor * AmplitudeAtOne * Math.Sqrt(density * angle * CellSize) / CellSize;
        }

        // In units. The beam brings the pattern in azimuth.
        double Amplitude(double section, double range, double elevationField)
        {
            double field = Antenna.Peak * elevationField;
            return Units * _equation.Amplitude(field, field, Math.Sqrt(section), range).Real;
        }

        // Metres to the horizon over a smooth sea.
        static double Horizon(double height) => Math.Sqrt(2 * ClutterGeometry.EarthRadius * Math.Max(0, height));
    }

    /// <summary>An echo of one point: GLINT_SCREEN_POINT in Shaders/ScreenPoints.hlsl.</summary>
    [System.Runtime.InteropServices.StructLayout(System.Runtime.InteropServices.LayoutKind.Sequential)]
    public struct ScreenPoint
    {
        /// <summary>From the antenna, metres: x to the east, y up, z to the north.</summary>
        public float3 Position;

        /// <summary>In units of the sums; 0: no echo.</summary>
        public float Amplitude;

        /// <summary>The complex echo in units of the sums.</summary>
        public float2 Field;

        /// <summary>Its spoke.</summary>
        public int Spoke;

        /// <summary>Its cell.</summary>
        public int Cell;
    }
}
