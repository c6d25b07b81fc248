using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>Which cross sections of a scene are computed, and how.</summary>
    public sealed class CrossSectionSetup
    {
        // Rounding of a length in float32, relative to the largest: half a step of 2^-23.
        const double Rounding = 1.0 / (1 << 24);

        // Largest error of a phase, rad, whatever the tolerance.
        const double MaxPhaseError = 0.12;

        // Of the error that the tolerance allows: what coefficients and looks may be off by in a shared trace.
        const double SharedPart = 0.1;

        // And at most over a band: range profiles are then within 60 dB below an echo for each of its bounces.
        const double MaxBandError = 1e-3;

        readonly Lazy<SurfacePatches[]> _patches;
        readonly Lazy<MeshQuality> _quality;
        readonly Lazy<WedgeSet> _wedges;
        readonly Lazy<RadarScene> _onEarth;
        readonly Lazy<double> _floor;
        SceneAhead _ahead;

        /// <summary>The setup of a scene.</summary>
        /// <param name="scene">The scene, with its materials.</param>
        /// <param name="plan">Directions, frequencies and receivers.</param>
        public CrossSectionSetup(RadarScene scene, CrossSectionPlan plan)
        {
            (Scene, Plan) = (scene, plan);
            (BoxMin, BoxMax) = scene.Bound();
            _patches = new Lazy<SurfacePatches[]>(Patches);
            _quality = new Lazy<MeshQuality>(() => MeshQuality.Find(Scene, _patches.Value));
            _wedges = new Lazy<WedgeSet>(() => EdgeBuffers.WedgesOf(PlacedScene, FoundPatches));
            _floor = new Lazy<double>(() => CrossSectionFloor.Of(scene, BoxMin, BoxMax));
            _onEarth = new Lazy<RadarScene>(() => CurvedEarth.Below(PhaseCentre, Scene));
        }

        /// <summary>The scene.</summary>
        public RadarScene Scene { get; }

        /// <summary>Directions, frequencies and receivers.</summary>
        public CrossSectionPlan Plan { get; }

        /// <summary>Corners of the box around the scene, metres, in its frame.</summary>
        public double3 BoxMin { get; }

        /// <inheritdoc cref="BoxMin"/>
        public double3 BoxMax { get; }

        /// <summary>Centre of that box, metres.</summary>
        public double3 BoxCentre => (BoxMin + BoxMax) / 2;

        /// <summary>Radius of the sphere around the scene's box, metres.</summary>
        public double Radius => math.distance(BoxMin, BoxMax) / 2;

        /// <summary>Distance of the box's farthest corner from the phase centre, metres.</summary>
        public double Extent =>
            math.length(math.max(math.abs(BoxMin - PhaseCentre), math.abs(BoxMax - PhaseCentre)));

        /// <summary>Elements of the scattering matrix that are written.</summary>
        public IReadOnlyList<Polarisation> Polarisations { get; set; } = Polarisation.All;

        /// <inheritdoc cref="CrossSectionPose.PhaseCentre"/>
        public double3 PhaseCentre { get; set; }

        /// <inheritdoc cref="CrossSectionPose.ToleranceDb"/>
        public double ToleranceDb { get; set; } = CrossSectionPose.DefaultToleranceDb;

        /// <inheritdoc cref="CrossSectionPose.FloorDbsm"/>
        public double? GivenFloorDbsm { get; set; }

        /// <summary>The floor, dBsm.</summary>
        public double FloorDbsm => GivenFloorDbsm ?? _floor.Value;

        /// <inheritdoc cref="CrossSectionPose.MaxBounces"/>
        public int MaxBounces { get; set; } = RadarSettings.Default.MaxBounces;

        /// <inheritdoc cref="CrossSectionPose.HasEdges"/>
        public bool HasEdges { get; set; } = true;

        /// <inheritdoc cref="CrossSectionPose.Range"/>
        public double Range { get; set; } = double.PositiveInfinity;

        /// <inheritdoc cref="CrossSectionPose.CreaseDegrees"/>
        public double CreaseDegrees { get; set; } = CrossSectionPose.DefaultCreaseDegrees;

        /// <summary>
        /// Whether each row says what the parts of the scene contribute, which takes one more trace a row.
        /// </summary>
        public bool HasContributions { get; set; }

        /// <summary>What is made of the responses over a band; null for cross sections alone.</summary>
        public EchoSettings Echo { get; set; }

        /// <inheritdoc cref="RunInfo.Backproject"/>
        public Func<IsarTransform, IReadOnlyList<System.Numerics.Complex[]>, System.Numerics.Complex[]> Backproject
        {
            get; set;
        }

        /// <summary>Names of the scene's objects, by their numbers, for results.json.</summary>
        public IReadOnlyList<string> ObjectNames { get; set; }

        /// <summary>Path of the scene or mesh file, for results.json; null for none.</summary>
        public string ScenePath { get; set; }

        /// <summary>Name of what is computed, for messages; null: the scene's path.</summary>
        public string Subject { get; set; }

        /// <summary>Number of objects of the scene, for results.json.</summary>
        public int Objects { get; set; }

        /// <summary>The command line, for results.json; null if there is none.</summary>
        public IReadOnlyList<string> Command { get; set; }

        /// <summary>How well the facets follow curved surfaces.</summary>
        public MeshQuality Quality => _quality.Value;

        /// <summary>The patches of each instance.</summary>
        internal SurfacePatches[] FoundPatches => _patches.Value;

        /// <summary>
        /// Edges without fringe fields because a face is no perfect conductor, and their length, metres. It waits until
        /// all edges are found, if there are such faces.
        /// </summary>
        public (int count, double length) CoatedEdges =>
            HasEdges && UsedMaterials().Any(material => !material.IsConductor)
                ? (_wedges.Value.CoatedCount, _wedges.Value.CoatedLength)
                : (0, 0);

        /// <summary>
        /// Begins to find what takes longest in the scene of the poses; from then on the scene and its materials,
        /// crease angle, edges, phase centre and range may not change.
        /// </summary>
        public void Begin() => _ahead ??= new SceneAhead(PlacedScene, () => FoundPatches,
            HasEdges ? () => _wedges.Value : (Func<WedgeSet>)null);

        /// <summary>What was begun, for one tracer.</summary>
        internal SceneAhead TakeAhead()
        {
            Begin();
            var ahead = _ahead;
            _ahead = null;
            return ahead;
        }

        /// <summary>
        /// Warnings of facets that are too coarse at the highest frequency, and of a target too small for the method at
        /// the lowest one.
        /// </summary>
        /// <param name="subject">Name of what is computed.</param>
        public IEnumerable<string> Warnings(string subject)
        {
            double highest = Plan.Frequencies.Last(), share = Quality.Share(Signal.Wavelength(highest));
            if (share > 0)
                yield return FormattableString.Invariant(
                    $"{subject}: the facets are too coarse for curved surfaces on {100 * share:0.#} % of the area at {highest:g4} Hz: their arcs rise more than 1/50 wavelength above them; the mesh is good up to {Quality.MaxFrequency:g4} Hz (column coarse_area_share): use a finer mesh or a lower frequency");
            if (ElectricalSize.Warning(subject, 2 * Radius, Plan.Frequencies.First()) is string warning)
                yield return warning;
        }

        /// <summary>Hash of a scene's meshes, places and materials, as in results.json.</summary>
        public static string ContentOf(RadarScene scene)
        {
            using (var hash = new SceneHash())
            {
                hash.Add(scene);
                return hash.Text();
            }
        }

        /// <summary>The pose of one row.</summary>
        public CrossSectionPose PoseOf(in PlannedCrossSection planned) =>
            PoseOf(planned, new[] { planned.ReceiverAspect }, new[] { planned.Frequency });

        // Level at the phase centre, where azimuth and elevation are given: the same for all rows.
        RadarScene PlacedScene => Scene.Seas.Count > 0 && !double.IsPositiveInfinity(Range) ? _onEarth.Value : Scene;

        /// <summary>
        /// The pose of a row, with some receivers and frequencies. At a finite range a scene with a sea lies on a curved
        /// earth.
        /// </summary>
        internal CrossSectionPose PoseOf(in PlannedCrossSection planned, RadarAspect[] receivers,
            double[] frequencies) =>
            new CrossSectionPose
            {
                Scene = PlacedScene, Radar = planned.Radar, Receivers = receivers, PhaseCentre = PhaseCentre,
                Range = planned.Range ?? Range,
                Frequencies = frequencies, MaxBounces = MaxBounces, HasEdges = HasEdges,
                CreaseDegrees = CreaseDegrees, ToleranceDb = ToleranceDb,
                Polarisations = Polarisations, FloorDbsm = FloorDbsm,
                BandCentre = Echo?.BandOf(Plan).Centre,
                RangeCell = Echo?.BandOf(Plan).RangeResolution ?? double.PositiveInfinity,
                Times = Enumerable.Range(0, Plan.PulseCount).Select(pulse => Plan.Pulses?.TimeOf(pulse) ?? 0).ToArray()
            };

        /// <summary>Refuses what cannot be computed, before any work on the device.</summary>
        /// <exception cref="GlintException">The message says what, and the way out.</exception>
        public void Validate(string subject)
        {
            if (Scene.TriangleCount == 0)
                throw new GlintException($"{subject}: has no triangles to compute a cross section of: "
                    + "activate an object with a mesh");
            if (HasContributions && Scene.Seas.Count > 0)
                throw new GlintException($"{subject}: contributions are those of mirror paths and edges, and a sea with clutter "
                    + "has a diffuse echo: leave --contributions out, or switch the clutter off");
            if (HasContributions && Scene.TriangleCount > CrossSectionContributions.MaxTriangles)
                throw new GlintException($"{subject}: has {Scene.TriangleCount} triangles, and contributions are "
                    + $"summed of at most {CrossSectionContributions.MaxTriangles}: leave --contributions out, or "
                    + "compute its parts alone");
            foreach (var material in UsedMaterials())
                foreach (double frequency in Plan.Frequencies)
                    material.RequireData(frequency);
            RequireLevels();
            if (Quality.Area == 0)
                throw new GlintException($"{subject}: no triangle has an area: it reflects nothing; export the mesh "
                    + "with more decimals, or check its unit");
            double highest = Plan.Frequencies.Last(), possible = MaxFrequency(ToleranceDb);
            if (highest > possible)
                throw new GlintException(FormattableString.Invariant(
                    $"{subject}: {highest:g6} Hz is too high for its size of {2 * Radius:g6} m and a tolerance of {ToleranceDb:g4} dB: phases in float32 are off by {PhaseError(highest):g2} rad; up to {possible:g4} Hz is possible{WithLargerTolerance(possible)}; or compute its parts alone"));
            if (Range <= Extent)
                throw new GlintException(FormattableString.Invariant(
                    $"{subject}: a range of {Range:g6} m is inside of it: its farthest corner is {Extent:g6} m from the phase centre; give a larger range"));
            if (WedgeFinder.FindOpenDielectric(Scene, _patches.Value) is SurfaceMaterial open)
                throw new GlintException($"{subject}: the surface with material '{open.Name}' is open, with air on "
                    + "both sides, but nothing is followed into a dielectric: close the mesh, or make it a perfect "
                    + "conductor (metal)");
        }

        string WithLargerTolerance(double possible) => MaxFrequency(double.PositiveInfinity) is double most && most > possible
            ? FormattableString.Invariant($", with a larger tolerance up to {most:g4} Hz")
            : "";

        // A spherical wave has many grazing angles.
        void RequireLevels()
        {
            if (!double.IsPositiveInfinity(Range) || Plan.Track != null)
                return;
            foreach (var sea in Scene.Seas)
                for (int row = 0; row < Plan.Count; row++)
                    sea.Clutter.RequireLevel(Plan[row].Radar, Plan[row].Frequency);
        }

        /// <summary>
        /// Largest error of phases in float32, radians: the way to a place and back, about the scene's centre, is at
        /// most the scene's size on either side.
        /// </summary>
        internal double PhaseError(double frequency) =>
            2 * Math.PI / Signal.Wavelength(frequency) * 2 * Radius * Rounding;

        /// <summary>The frequency up to which phases in float32 suffice for a tolerance, hertz.</summary>
        internal double MaxFrequency(double toleranceDb) =>
            Math.Min(MaxPhaseError, CrossSectionAccuracy.AllowedBy(toleranceDb)) / PhaseError(1);

        /// <summary>Relative error that reflection coefficients may have where frequencies share a trace.</summary>
        internal double MaxCoefficientError =>
            Math.Min(SharedError, Echo == null ? double.PositiveInfinity : MaxBandError);

        double SharedError => SharedPart * CrossSectionAccuracy.AllowedBy(ToleranceDb);

        /// <summary>
        /// Looks of an image that share a trace. Those of anything else have their own, and those with the clutter of a
        /// sea.
        /// </summary>
        public LookGroups Looks => Echo?.Image == null || Plan.Pulses != null || Plan.IsBistatic
            || !double.IsPositiveInfinity(Range) || Scene.Seas.Count > 0 || HasContributions
                ? new LookGroups()
                : new LookGroups(Plan, BoxMin - PhaseCentre, BoxMax - PhaseCentre, SharedError, MaxBandError);

        /// <summary>Materials of triangles.</summary>
        internal IReadOnlyList<SurfaceMaterial> UsedMaterials() => Scene.Instances
            .SelectMany(instance => instance.Ranges).Select(range => range.Surface).Distinct()
            .OrderBy(surface => surface).Select(surface => Scene.Surfaces[surface]).ToArray();

        SurfacePatches[] Patches()
        {
            var known = new Dictionary<TriangleMesh, SurfacePatches>();
            return Array.ConvertAll(Scene.Instances, instance =>
            {
                if (!known.TryGetValue(instance.Mesh, out var patches))
                    known.Add(instance.Mesh, patches =
                        SurfacePatches.Find(instance.Mesh, instance.Ranges, CreaseDegrees));
                return patches;
            });
        }
    }
}
