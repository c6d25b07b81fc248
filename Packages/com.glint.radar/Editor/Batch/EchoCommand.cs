using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Glint.Core;
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
            var (min, max) = opened.scene.Bound();
            double reach = EchoBand.Reach(min, max, CrossSectionCommand.PhaseCentreOf(line, opened.scene));
            var plan = EchoOptions.PlanOf(line, reach);
            var setup = CrossSectionCommand.SetupOf(line, opened, plan);
            setup.Echo = settings;
            Describe(settings.BandOf(plan), reach, opened.name, progress);
            if (line.Command == Commands.Isar)
                settings.Image = ImageOf(line, setup, opened.name, progress);
            return CrossSectionCommand.Compute(line, setup, opened.name, ResultTable.Echo, new EchoTable(setup),
                progress);
        }

        static IsarSettings ImageOf(CommandLine line, CrossSectionSetup setup, string name, IProgressSink progress)
        {
            var band = setup.Echo.BandOf(setup.Plan);
            double[] looks = line.Get(CrossSectionOptions.Azimuth);
            var image = EchoOptions.ImageOf(line, band, setup.Extent);
            double bin = EchoOptions.CrossBin(band, looks), unambiguous = looks.Length * bin;
            progress.Print(FormattableString.Invariant(
                $"image {image.Side:g5} m wide, {image.Pixels} x {image.Pixels} pixels, cross-range bin {bin:g4} m, unambiguous cross range {unambiguous:g5} m"));
            if (unambiguous < 2 * setup.Extent)
                Debug.LogWarning(FormattableString.Invariant(
                    $"{name}: the unambiguous cross range is {unambiguous:g4} m, but the target may take {2 * setup.Extent:g4} m: parts may be folded over others; give a smaller step for {CrossSectionOptions.Azimuth.Flag}"));
            return image;
        }

        static void Describe(FrequencyBand band, double reach, string name, IProgressSink progress)
        {
            progress.Print(FormattableString.Invariant(
                $"{band.Count} frequencies from {band.Frequency(0):g9} to {band.Frequency(band.Count - 1):g9} Hz, range bin {band.RangeResolution:g4} m, unambiguous range {band.UnambiguousRange:g5} m"));
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
        readonly Dictionary<int, List<CrossSectionRow>> _rows = new Dictionary<int, List<CrossSectionRow>>();

        public EchoTable(CrossSectionSetup setup) =>
            (_setup, _range) = (setup, setup.Echo.RangeOf(setup.Plan));

        public string Header => CrossSectionTable.HeaderOf(_setup, "") + string.Concat(_setup.Polarisations.Select(
            polarisation => $"{polarisation.Name.ToUpperInvariant() + " dBsm",10}{"at m",10}")) + "  error dB";

        public string Add(CrossSectionRow row)
        {
            if (row.Planned.FrequencyIndex == 0 || !_rows.TryGetValue(row.Planned.Receiver, out var rows))
                _rows[row.Planned.Receiver] = rows = new List<CrossSectionRow>();
            rows.Add(row);
            // A resumed run or a part may begin within a direction.
            if (rows.Count < _setup.Plan.Frequencies.Count || rows[0].Planned.Pose != row.Planned.Pose)
                return null;
            return CrossSectionTable.DirectionOf(_setup, row, "")
                + string.Concat(_setup.Polarisations.Select(polarisation =>
                    Peak(rows.Select(each => polarisation.Of(each.S)).ToArray())))
                + FormattableString.Invariant($"  {rows.Max(each => each.Accuracy.ErrorDb),8:0.000}")
                + (rows.All(each => each.MeetsTolerance) ? "" : " !");
        }

        string Peak(Complex[] responses)
        {
            var profile = _range.Profile(responses);
            int cell = EchoPeak.Of(profile);
            return $"{CrossSectionTable.Level(profile[cell]),10}"
                + FormattableString.Invariant($"{_range.RangeOf(cell),10:0.000}");
        }
    }
}
