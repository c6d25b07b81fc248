using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The diffuse echo of a sea at one time, for kernels and commands: what the facets of its tile scatter, which of
    /// them break, and how their echo changes in time. Immutable.
    /// </summary>
    public sealed class SeaClutter
    {
        /// <summary>
        /// Exponent of <see cref="ClutterMotion.ApproachingShare"/>: short waves are divided between both ways along
        /// the radar's direction as cos^4 of half the angle to the wind. Along and across the wind the share does not
        /// depend on it.
        /// </summary>
        public const double ApproachingExponent = 2;

        // Rounding of a direction that was given in float32.
        const double DirectionTolerance = 1e-5;

        // Of degrees, as far as float32 gives them.
        const int AngleDecimals = 3;

        readonly Dictionary<double, FacetTable> _tables;
        readonly Lazy<bool[]> _breakingFacets;
        readonly Lazy<double3[]> _facetVelocities;
        readonly Lazy<double[]> _logWinds;
        readonly Lazy<double> _waveHeight;

        /// <summary>The echo of a sea.</summary>
        /// <param name="longWaves">The waves of its mesh.</param>
        /// <param name="time">Seconds.</param>
        /// <param name="wind">Direction in which the wind blows, in the world: horizontal, of length 1.</param>
        /// <param name="settings">The settings of the echo; whether it is on is not read.</param>
        /// <exception cref="GlintException">
        /// A setting is out of its range, or the mesh ends outside the wave numbers of the short waves' spectrum.
        /// </exception>
        public SeaClutter(SeaSurface longWaves, double time, double3 wind, SeaClutterSettings settings)
            : this(longWaves, time, wind, settings, null)
        {
        }

        SeaClutter(SeaSurface longWaves, double time, double3 wind, in SeaClutterSettings settings, SeaClutter other)
        {
            if (!(Math.Abs(math.length(wind) - 1) < DirectionTolerance && Math.Abs(wind.y) < DirectionTolerance))
                throw new ArgumentOutOfRangeException(nameof(wind), wind, "horizontal, of length 1");
            settings.Validate();
            (LongWaves, Time, Settings) = (longWaves, time, settings);
            Wind = math.normalize(new double3(wind.x, 0, wind.z));
            ShortWaves = other?.ShortWaves ?? new ShortWaves(longWaves, settings.Wind);
            Water = other?.Water ?? Medium.SeaWater(settings.WaterTemperature, settings.Salinity);
            Surface = other?.Surface ?? new SurfaceMaterial("sea water", null, Water, ShortWaves.Height);
            BreakingFraction = new WhitecapLaw(settings.WhitecapCoefficient).Fraction(ShortWaves.Wind);
            _tables = other?._tables ?? new Dictionary<double, FacetTable>();
            _waveHeight = other?._waveHeight ?? new Lazy<double>(FindWaveHeight);
            _breakingFacets = new Lazy<bool[]>(FindBreakingFacets);
            _facetVelocities = new Lazy<double3[]>(FindFacetVelocities);
            _logWinds = new Lazy<double[]>(() =>
                new Gusts(ShortWaves.Wind, Settings.Gustiness).LogWinds(LongWaves, Seed, Time));
        }

        /// <summary>The waves of the mesh.</summary>
        public SeaSurface LongWaves { get; }

        /// <summary>Time of the mesh, seconds.</summary>
        public double Time { get; }

        /// <summary>The settings.</summary>
        public SeaClutterSettings Settings { get; }

        /// <summary>The waves that the mesh leaves out.</summary>
        public ShortWaves ShortWaves { get; }

        /// <summary>Direction in which the wind blows, in the world: horizontal, of length 1.</summary>
        public double3 Wind { get; }

        /// <summary>The water.</summary>
        public Medium Water { get; }

        /// <summary>
        /// The mirror part of the facets: sea water with the roughness of all waves that the mesh leaves out.
        /// </summary>
        public SurfaceMaterial Surface { get; }

        /// <summary>Seed of speckle and gusts.</summary>
        public uint Seed => (uint)Settings.Seed;

        /// <summary>Fraction of the facets that break.</summary>
        public double BreakingFraction { get; }

        /// <summary>
        /// Whether each triangle of the tile's mesh breaks, in the order of its triangles: the
        /// <see cref="BreakingFraction"/> with the largest downward acceleration of the linear waves at the windward corner
        /// of their cell, so that waves break on their forward faces.
        /// </summary>
        public IReadOnlyList<bool> BreakingFacets => _breakingFacets.Value;

        /// <summary>
        /// Natural logarithm of the wind over its mean, at each cell of the tile. Triangles 2 i and 2 i + 1 are cell i.
        /// Ripples follow it; the waves that break do not.
        /// </summary>
        public IReadOnlyList<double> LogWinds => _logWinds.Value;

        /// <summary>
        /// Velocity of the water of each triangle of the tile's mesh, in the order of its triangles, in the tile's
        /// frame, m/s: the mean over its corners, of the linear waves.
        /// </summary>
        public IReadOnlyList<double3> FacetVelocities => _facetVelocities.Value;

        /// <summary>Level, wind, water, whitecaps, gustiness and seed in one line.</summary>
        public override string ToString() => FormattableString.Invariant(
            $"{ClutterModel.NameOf(Settings.Level)}, wind {ShortWaves.Wind:0.###} m/s, {Water}, whitecaps {Settings.WhitecapCoefficient:g3}, gustiness {Settings.Gustiness:g3}, seed {Settings.Seed}");

        /// <summary>The echo of the same sea at another time. Both share their tables.</summary>
        public SeaClutter At(double time) => new SeaClutter(LongWaves, time, Wind, Settings, this);

        /// <summary>
        /// Sigma0 of the facets over their direction. Computed once a frequency, which takes a part of a second.
        /// </summary>
        /// <param name="frequency">Hz.</param>
        /// <exception cref="GlintException">
        /// The frequency is not one of <see cref="SeaScattering.Frequencies"/>, or so low that the mesh itself holds
        /// Bragg waves.
        /// </exception>
        public FacetTable TableAt(double frequency)
        {
            lock (_tables)
            {
                if (!_tables.TryGetValue(frequency, out var table))
                    _tables.Add(frequency, table = MakeTable(frequency));
                return table;
            }
        }

        /// <summary>
        /// Douglas sea state, by the requested height of the waves. If none is requested, by the height that the spectrum
        /// has with a limited fetch, or that the wind raises. Above 6 no published model holds.
        /// </summary>
        public double SeaState => SeaStateFits.OfAnyHeight(_waveHeight.Value);

        /// <summary>What published models are asked for.</summary>
        /// <param name="frequency">Hz.</param>
        /// <param name="azimuthDegrees">As of <see cref="RadarAspect.At"/>.</param>
        public ClutterConditions ConditionsAt(double frequency, double azimuthDegrees, double grazingDegrees) =>
            new ClutterConditions(frequency, grazingDegrees, SeaState, AngleBetween(azimuthDegrees, Wind));

        /// <summary>Refuses a plane wave for which the published level of the sea, if it has one, does not hold.</summary>
        /// <param name="frequency">Hz.</param>
        /// <exception cref="GlintException">The message says where it holds.</exception>
        public void RequireLevel(in RadarAspect radar, double frequency)
        {
            // Rounded as a float32 may be, so that the last angle of a model is in its range.
            if (Settings.Level != ClutterLevel.Physics)
                ClutterModel.Of(Settings.Level).Require(ConditionsAt(frequency, radar.AzimuthDegrees,
                    Math.Round(radar.ElevationDegrees, AngleDecimals)));
        }

        // From a horizontal direction to that of the radar, degrees.
        static double AngleBetween(double azimuthDegrees, double3 direction)
        {
            double cosine = math.dot(RadarAspect.At(azimuthDegrees, 0).ToRadar, direction);
            return math.degrees(Math.Acos(Math.Max(-1, Math.Min(1, cosine))));
        }

        /// <summary>
        /// Angle in degrees from the direction in which the swell travels to that of the radar; null without swell.
        /// </summary>
        /// <param name="azimuthDegrees">As of <see cref="RadarAspect.At"/>.</param>
        public double? SwellAngleAt(double azimuthDegrees)
        {
            var waves = LongWaves.Settings;
            if (waves.SwellHeight == 0)
                return null;
            double turn = math.radians(waves.SwellDirectionDegrees - waves.WindDirectionDegrees), sine = Math.Sin(turn),
                cosine = Math.Cos(turn);
            var swell = new double3(cosine * Wind.x + sine * Wind.z, 0, cosine * Wind.z - sine * Wind.x);
            return AngleBetween(azimuthDegrees, swell);
        }

        /// <summary>
        /// Time in seconds in which the speckle of a facet decorrelates: <see cref="ClutterMotion.CoherenceTime"/> of
        /// half the shortest wave of the mesh, the side of its facets.
        /// </summary>
        /// <param name="frequency">Hz.</param>
        public double CoherenceTimeAt(double frequency) => ClutterMotion.CoherenceTime(
            Signal.Wavelength(frequency), ShortWaves.Wind, Math.PI / ShortWaves.Cut);

        FacetTable MakeTable(double frequency)
        {
            var (permittivity, _) = Water.At(frequency);
            var scattering = new SeaScattering(frequency, permittivity, ShortWaves.Spectrum.Density);
            if (ShortWaves.Cut > scattering.TiltCut)
                throw new GlintException($"sea clutter: at {Medium.Number(frequency)} Hz the mesh holds waves up to "
                    + $"{RadarSettings.Text(ShortWaves.Cut)} rad/m, and waves from "
                    + $"{RadarSettings.Text(scattering.TiltCut)} rad/m on are Bragg waves, which would count twice: "
                    + "give the sea fewer cells, or a higher frequency");
            // What its facets lose of the mesh's own waves is unresolved too.
            var (along, across) = ShortWaves.SlopeVariances(ShortWaves.Cut, scattering.TiltCut);
            double2 all = LongWaves.SlopeVariances(ShortWaves.Cut) + new double2(along, across);
            var (resolved, covariance) = LongWaves.FacetSlopeVariances();
            return new FacetTable(scattering, resolved, math.max(0, all - resolved), -covariance,
                ShortWaves.WindExponent);
        }

        double FindWaveHeight()
        {
            var waves = LongWaves.Settings;
            if (waves.SignificantWaveHeight > 0)
                return waves.SignificantWaveHeight;
            bool isLimited = waves.Kind == SeaSpectrumKind.Jonswap
                || waves.Kind == SeaSpectrumKind.Elfouhaily && waves.Fetch > 0;
            return isLimited ? SeaSpectrum.SignificantHeight(waves) : SeaStateFits.WaveHeightOfWind(ShortWaves.Wind);
        }

        double3[] FindFacetVelocities()
        {
            var ofVertices = LongWaves.Velocities(Time);
            var indices = LongWaves.Indices;
            var velocities = new double3[indices.Count / 3];
            for (int i = 0; i < velocities.Length; i++)
                velocities[i] = (ofVertices[indices[3 * i]] + ofVertices[indices[3 * i + 1]]
                    + ofVertices[indices[3 * i + 2]]) / 3;
            return velocities;
        }

        bool[] FindBreakingFacets()
        {
            double[] ofVertices = LongWaves.Accelerations(Time);
            var indices = LongWaves.Indices;
            int[] crest = WindwardCorners();
            var accelerations = new double[indices.Count / 3];
            // Of both triangles of a cell at its windward corner, the crest: waves break on their forward faces. A mean
            // over corners would lose the shortest waves, which accelerate most.
            for (int i = 0; i < accelerations.Length; i++)
            {
                double least = double.PositiveInfinity;
                foreach (int corner in crest)
                    least = Math.Min(least, ofVertices[indices[i / 2 * 6 + corner]]);
                accelerations[i] = least;
            }
            int[] order = Enumerable.Range(0, accelerations.Length).ToArray();
            Array.Sort(accelerations, order);
            var breaks = new bool[accelerations.Length];
            int count = (int)Math.Floor(BreakingFraction * breaks.Length + 0.5);
            for (int i = 0; i < count; i++)
                breaks[order[i]] = true;
            return breaks;
        }

        // Of the six corners of a cell's triangles, the same in all cells. Two of them may be at one distance.
        int[] WindwardCorners()
        {
            double direction = math.radians(LongWaves.Settings.WindDirectionDegrees);
            int side = LongWaves.Settings.Cells + 1;
            double[] alongWind = LongWaves.Indices.Take(6).Select(vertex => Math.Round(
                vertex % side * Math.Sin(direction) + vertex / side * Math.Cos(direction), 6)).ToArray();
            return Enumerable.Range(0, 6).Where(corner => alongWind[corner] == alongWind.Min()).ToArray();
        }
    }
}
