using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Core
{
    /// <summary>The columns of clutter.csv.</summary>
    public static class ClutterColumn
    {
        /// <summary>The published models beside the sea's echo: names, and titles for plots.</summary>
        public static readonly IReadOnlyList<(string Name, string Title)> Models =
            ClutterModel.All.Select(model => (model.Name, model.Title)).ToArray();

        /// <summary>Every column, in the order of the file.</summary>
        public static IReadOnlyList<ResultColumn> All { get; } = ResultColumn.Number(new[]
            {
                ResultColumn.MissingAllowed(Of("snapshot", "Snapshot", "1", row => row.Snapshot)),
                Of("time_s", "Time", "s", row => row.TimeSeconds),
                Of("frequency_hz", "Frequency", "Hz", row => row.Conditions.Frequency),
                Of("azimuth_deg", "Azimuth", "deg", row => row.AzimuthDegrees),
                Of("wind_angle_deg", "Angle to the wind", "deg", row => row.Conditions.WindAngleDegrees),
                Of("grazing_deg", "Grazing angle", "deg", row => row.Conditions.GrazingDegrees),
                Level("vv", row => row.Sigma0.VV), Level("hh", row => row.Sigma0.HH), Level("hv", row => row.Sigma0.HV),
                Of("lit_fraction", "Lit fraction", "1", row => row.LitFraction),
                Of("cells", "Cells of the shapes", "1", row => row.Cells),
                OfTexture("shape_vv", "Shape, VV", row => row.ShapeVV), OfTexture("shape_hh", "Shape, HH", row => row.ShapeHH),
                OfTexture("measured_shape_vv", "Measured shape, VV", row => row.MeasuredShapeVV),
                OfTexture("measured_shape_hh", "Measured shape, HH", row => row.MeasuredShapeHH)
            }.Concat(Models.SelectMany((model, i) => new[]
            {
                ResultColumn.MissingAllowed(Of($"{model.Name}_vv_db", $"{model.Title}, VV", "dB", row => row.Models[i].VV)),
                ResultColumn.MissingAllowed(Of($"{model.Name}_hh_db", $"{model.Title}, HH", "dB", row => row.Models[i].HH))
            })).ToArray());

        // Without decibels where nothing is lit.
        static ResultColumn Level(string polarisation, Func<ClutterRow, double> value) => ResultColumn.MissingAllowed(Of(
            $"sigma0_{polarisation}_db", $"Sigma0, {polarisation.ToUpperInvariant()}", "dB",
            row => value(row) > 0 ? Sigma0.Decibels(value(row)) : (double?)null));

        static ResultColumn OfTexture(string name, string title, Func<ClutterRow, double?> value) =>
            ResultColumn.MissingAllowed(Of(name, title, "1", value));

        static ResultColumn Of(string name, string title, string unit, Func<ClutterRow, double?> value) =>
            ResultColumn.Of(name, title, unit, value);
    }
}
