using System;
using System.Collections.Generic;
using System.Linq;
using Complex = System.Numerics.Complex;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// <c>glint echo</c>: responses of a scene or a mesh file over a band, and range profiles; <c>glint isar</c>: an
    /// image of its looks too.
    /// </summary>
    static class EchoCommand
    {
        public static int Execute(CommandLine line, IProgressSink progress)
        {
            var settings = EchoOptions.SettingsOf(line);
            var opened = CrossSectionCommand.OpenScene(line);
            if (line.InputKind == InputKind.MeshFile)
                Move(opened.scene, EchoOptions.MotionOf(line, CrossSectionCommand.PhaseCentreOf(line, opened.scene)));
            var (min, max) = opened.scene.Bound();
            bool isFarMonostatic = !new Option[]
                { CrossSectionOptions.Range, CrossSectionOptions.Bistatic, CrossSectionOptions.Receivers }.Any(line.IsGiven);
            double reach = EchoBand.Reach(min, max, CrossSectionCommand.PhaseCentreOf(line, opened.scene),
                isFarMonostatic);
            var plan = EchoOptions.PlanOf(line, reach);
            var setup = CrossSectionCommand.SetupOf(line, opened, plan);
            setup.Echo = settings;
            if (settings.Detection != null && settings.Radar?.NoiseFigureDb == null && opened.scene.Seas.Count == 0)
                throw new UsageException($"{EchoOptions.Detect.Flag}: there is nothing but echoes to detect in: give "
                    + $"{EchoOptions.NoiseFigure.Flag}, or a scene with a Sea whose clutter is on");
            if (settings.Radar?.Antenna is EchoAntenna antenna)
                RequireInBeam(antenna, setup, opened.name);
            RequireMatlab(settings, plan);
            Describe(settings.BandOf(plan), reach, opened.name, progress);
            WarnOfFacets(settings.BandOf(plan), plan, opened.scene, opened.name);
            if (plan.Pulses != null)
                DescribePulses(settings.BandOf(plan), plan, opened.scene, opened.name, progress);
            bool isImage = line.Command == Commands.Isar;
            if (isImage)
            {
                settings.Image = ImageOf(line, setup, opened.name, progress);
                progress.Print($"azimuths of a trace: {setup.Looks.Looks}");
            }
            using (var imager = isImage ? new IsarImager(ProjectAssets.ImageKernel, opened.name) : null)
            {
                if (isImage)
                    setup.Backproject = imager.Image;
                return isImage
                    ? CrossSectionCommand.Compute(line, setup, opened.name, ResultTable.Image, null, progress)
                    : CrossSectionCommand.Compute(line, setup, opened.name, ResultTable.Echo, new EchoTable(setup),
                        progress);
            }
        }

        // The arrays are written after the last row.
        static void RequireMatlab(EchoSettings settings, CrossSectionPlan plan)
        {
            if (!settings.HasMatlab)
                return;
            var range = settings.RangeOf(plan);
            int rows = settings.DopplerOf(plan, range)?.Rows ?? 1;
            long numbers = (long)Polarisation.Matrix.Count * plan.Poses * plan.Receivers * rows * range.Cells;
            if (numbers > MatlabFile.MaxComplexNumbers)
                throw new UsageException(FormattableString.Invariant(
                    $"{EchoOptions.Matlab.Flag}: the {(plan.Pulses == null ? "profiles" : "maps")} of the run have {numbers:N0} complex numbers, and an array of a MAT-file has at most {MatlabFile.MaxComplexNumbers:N0}: leave it out, echo.npz has the same arrays, or ask for fewer directions, pulses or frequencies"));
        }

        // The gain towards the phase centre is that of the whole target.
        static void RequireInBeam(EchoAntenna antenna, CrossSectionSetup setup, string name)
        {
            double angle = math.degrees(2 * Math.Atan(setup.Extent / setup.Range)),
                atMost = EchoAntenna.MaxPartOfBeam * antenna.Width;
            if (angle > atMost)
                throw new GlintException(FormattableString.Invariant(
                    $"{name}: the target is {angle:g3} degrees wide at {CrossSectionOptions.Range.Flag} {setup.Range:g6}, and all of it gets the gain of the phase centre: it may take {atMost:g3} degrees, a tenth of the beam; give a range of {Math.Ceiling(setup.Extent / Math.Tan(math.radians(atMost / 2))):g6} m or more, a wider {EchoOptions.Beam.Flag}, or no {EchoOptions.AntennaPattern.Flag}"));
        }

        static void Move(RadarScene scene, RigidMotion motion)
        {
            for (int i = 0; i < scene.Instances.Length; i++)
                scene.Instances[i].Motion = motion;
        }

        // A facet of a sea answers from its middle, whatever the frequency.
        static void WarnOfFacets(FrequencyBand band, CrossSectionPlan plan, RadarScene scene, string name)
        {
            if (scene.Seas.Count == 0)
                return;
            double cosine = Enumerable.Range(0, plan.Poses)
                .Max(pose => Math.Cos(math.radians(plan[pose * (plan.Count / plan.Poses)].ElevationDegrees)));
            foreach (var waves in scene.Seas.Select(sea => sea.Clutter.LongWaves.Settings))
            {
                double along = waves.TileSize / waves.Cells * cosine;
                if (along > band.RangeResolution)
                    Debug.LogWarning(FormattableString.Invariant(
                        $"{name}: a facet of the sea takes {along:g3} m along the line of sight and answers from its middle, and a range bin is {band.RangeResolution:g4} m: the mean of the sea's echo has peaks and gaps over range; give the sea at least {Math.Ceiling(waves.TileSize * cosine / band.RangeResolution)} Cells, or {EchoOptions.Bandwidth.Flag} of at most {Math.Floor(Signal.SpeedOfLight / (2e6 * along))}e6"));
            }
        }

        static void DescribePulses(FrequencyBand band, CrossSectionPlan plan, RadarScene scene, string name,
            IProgressSink progress)
        {
            var pulses = plan.Pulses;
            double blind = pulses.BlindSpeed(band.Centre), ofObjects = FastestOf(plan, scene),
                fastest = Math.Max(ofObjects, FastestOfSeas(scene, band.Centre)),
                duration = pulses.TimeOf(pulses.Count - 1), bins = ofObjects * duration / band.RangeResolution;
            progress.Print(FormattableString.Invariant(
                $"{pulses.Count} pulses at {pulses.RepetitionFrequency:g6} Hz, speed bin {pulses.SpeedResolution(band.Centre):g4} m/s, blind speed {blind:g4} m/s"));
            if (!scene.IsMoving && scene.Seas.Count == 0)
                progress.Print("note: nothing moves: all echoes have the speed 0");
            if (fastest > blind / 2)
                Debug.LogWarning(FormattableString.Invariant(
                    $"{name}: up to {fastest:g4} m/s along the line of sight, and speeds above half of the blind speed, {blind / 2:g4} m/s, are folded; give a {EchoOptions.Repetition.Flag} of at least {pulses.RepetitionFrequency * 2 * fastest / blind:0}"));
            if (bins > 1)
                Debug.LogWarning(FormattableString.Invariant(
                    $"{name}: up to {bins * band.RangeResolution:g3} m along the line of sight in the {duration:g3} s of the pulses, and a range bin is {band.RangeResolution:g4} m: such an echo spreads over range and speed, and its peak in the map is lower; end the pulses within {duration / bins:g3} s ({EchoOptions.Pulses.Flag}, {EchoOptions.Repetition.Flag}), or give {EchoOptions.Bandwidth.Flag} of at most {Math.Floor(band.Bandwidth / bins / 1e6):0}e6"));
        }

        // Largest speed towards or away from the radar, of corners of the boxes around what moves.
        static double FastestOf(CrossSectionPlan plan, RadarScene scene)
        {
            double fastest = 0;
            foreach (var instance in scene.Instances.Where(instance => !instance.Motion.IsNone))
            {
                var (min, max) = new RadarScene(instance).Bound();
                for (int corner = 0; corner < 8; corner++)
                {
                    var velocity = instance.Motion.VelocityAt(Box.CornerOf(min, max, corner));
                    for (int row = 0; row < plan.Count; row += plan.Count / plan.Poses)
                        for (int receiver = 0; receiver < plan.Receivers; receiver++)
                            fastest = Math.Max(fastest, Math.Abs(math.dot(velocity,
                                plan[row].Radar.ToRadar + plan[row + receiver].ReceiverAspect.ToRadar)) / 2);
                }
            }
            return fastest;
        }

        // Of the water of facets, in any direction, and the Bragg waves on it.
        static double FastestOfSeas(RadarScene scene, double frequency)
        {
            double bragg = 4 * Math.PI / Signal.Wavelength(frequency);
            return scene.Seas.Count == 0 ? 0 : ClutterMotion.AngularFrequency(bragg) / bragg
                + scene.Seas.SelectMany(sea => sea.Clutter.FacetVelocities).Max(velocity => math.length(velocity));
        }

        static IsarSettings ImageOf(CommandLine line, CrossSectionSetup setup, string name, IProgressSink progress)
        {
            var band = setup.Echo.BandOf(setup.Plan);
            var image = EchoOptions.ImageOf(line, band, setup.Plan, setup.Extent);
            double bin = IsarSettings.CrossBin(band, setup.Plan), unambiguous = setup.Plan.Poses * bin;
            progress.Print(FormattableString.Invariant(
                $"image {image.Side:g5} m wide, {image.Pixels} x {image.Pixels} pixels, down-range bin {IsarSettings.DownBin(band, setup.Plan):g4} m, cross-range bin {bin:g4} m, unambiguous cross range {unambiguous:g5} m"));
            double needed = (image.Side / 2 + HalfWidthOf(setup)) * band.Frequency(band.Count - 1) / band.Centre;
            if (unambiguous < needed)
                Debug.LogWarning(FormattableString.Invariant(
                    $"{name}: the unambiguous cross range is {unambiguous:g4} m, but half of the image and of the target take {needed:g4} m: copies of parts may be in the image; give a smaller step for {(line.IsGiven(EchoOptions.Track) ? EchoOptions.Track : (Option)CrossSectionOptions.Azimuth).Flag}, or a smaller {EchoOptions.Side.Flag}"));
            return image;
        }

        // Of the target along the image's cross range, on the wider side of the phase centre.
        static double HalfWidthOf(CrossSectionSetup setup)
        {
            var plan = setup.Plan;
            double middle = plan.Track?.AzimuthDegrees
                ?? 0.5 * (plan[0].AzimuthDegrees + plan[plan.Count - 1].AzimuthDegrees);
            return math.dot(math.abs(RadarAspect.At(middle, 0).Right),
                math.max(math.abs(setup.BoxMin - setup.PhaseCentre), math.abs(setup.BoxMax - setup.PhaseCentre)));
        }

        static void Describe(FrequencyBand band, double reach, string name, IProgressSink progress)
        {
            progress.Print(FormattableString.Invariant(
                $"{band.Count} frequencies from {band.Frequency(0):g9} to {band.Frequency(band.Count - 1):g9} Hz, range bin {band.RangeResolution:g4} m, unambiguous range {band.UnambiguousRange:g5} m"));
            if (band.RangeResolution > 2 * reach)
                Debug.LogWarning(FormattableString.Invariant(
                    $"{name}: a range bin of {band.RangeResolution:g4} m holds all of its echoes, which take {2 * reach:g4} m: a profile shows one peak; give a larger {EchoOptions.Bandwidth.Flag}, in hertz"));
            if (band.UnambiguousRange < 2 * reach)
                Debug.LogWarning(FormattableString.Invariant(
                    $"{name}: the unambiguous range is {band.UnambiguousRange:g4} m, but echoes of up to two bounces take {2 * reach:g4} m: some may be folded over others; give at least {EchoBand.CountFor(reach, band.Bandwidth):0} for {EchoOptions.Frequencies.Flag}"));
        }
    }

    /// <summary>The table that <c>glint echo</c> prints: the highest echo of each direction.</summary>
    sealed class EchoTable : IRowLines
    {
        readonly CrossSectionSetup _setup;
        readonly RangeTransform _range;
        readonly RangeDopplerTransform _doppler;
        readonly Dictionary<int, List<CrossSectionRow>> _rows = new Dictionary<int, List<CrossSectionRow>>();

        public EchoTable(CrossSectionSetup setup)
        {
            (_setup, _range) = (setup, setup.Echo.RangeOf(setup.Plan));
            _doppler = setup.Echo.DopplerOf(setup.Plan, _range);
        }

        public string Header => CrossSectionTable.HeaderOf(_setup, "") + string.Concat(_setup.Polarisations.Select(
            polarisation => $"{polarisation.Name.ToUpperInvariant() + " dBsm",10}{"at m",10}"
                + (_doppler == null ? "" : $"{"at m/s",10}"))) + "  error dB";

        public string Add(CrossSectionRow row)
        {
            if (row.Planned.FrequencyIndex == 0 && row.Planned.Pulse == 0
                || !_rows.TryGetValue(row.Planned.Receiver, out var rows))
                _rows[row.Planned.Receiver] = rows = new List<CrossSectionRow>();
            rows.Add(row);
            // A resumed run or a part may begin within a direction.
            if (rows.Count < _setup.Plan.PulseCount * _setup.Plan.Frequencies.Count
                || rows[0].Planned.Pose != row.Planned.Pose)
                return null;
            return CrossSectionTable.DirectionOf(_setup, row, "")
                + string.Concat(_setup.Polarisations.Select(polarisation =>
                    Peak(rows.Select(each => polarisation.Of(each.S)).ToArray())))
                + FormattableString.Invariant($"  {rows.Max(each => each.Accuracy.ErrorDb),8:0.000}")
                + (rows.All(each => each.MeetsTolerance) ? "" : " !");
        }

        string Peak(Complex[] responses)
        {
            int frequencies = _setup.Plan.Frequencies.Count;
            var cells = _doppler == null
                ? _range.Profile(responses)
                : _doppler.Map(Enumerable.Range(0, _setup.Plan.PulseCount).Select(pulse =>
                    (IReadOnlyList<Complex>)new ArraySegment<Complex>(responses, pulse * frequencies, frequencies))
                        .ToArray());
            int cell = EchoPeak.Of(cells);
            // HV and VH of a symmetric target have no highest place.
            if (cells[cell] == Complex.Zero)
                return $"{"-",10}{"-",10}" + (_doppler == null ? "" : $"{"-",10}");
            return $"{CrossSectionTable.Level(cells[cell]),10}"
                + FormattableString.Invariant($"{_range.RangeOf(cell % _range.Cells),10:0.000}")
                + (_doppler == null
                    ? ""
                    : FormattableString.Invariant($"{_doppler.SpeedOf(cell / _range.Cells),10:0.000}"));
        }
    }
}
