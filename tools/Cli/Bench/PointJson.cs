using System.IO;
using System.Linq;
using Glint.Core;
using Newtonsoft.Json.Linq;

namespace Glint.Cli;

/// <summary>Rays of ray tubes and of point sampling as JSON. Times are in milliseconds, those of points medians.</summary>
static class PointJson
{
    public static void Write(Stream stream, PointResult result) => JsonText.Write(stream, new JObject
    {
        ["device"] = result.Device.Name,
        ["driver"] = result.Device.Driver,
        ["glint"] = GlintVersion.Text,
        ["subject"] = result.Subject,
        ["triangles"] = result.Triangles,
        ["frequency_hz"] = result.FrequencyHz,
        ["grazing_deg"] = result.GrazingDegrees,
        ["tolerance_db"] = PointResult.ToleranceDb,
        ["side_m"] = result.Side,
        ["offsets"] = result.Offsets,
        ["directions"] = new JArray(result.Rows.Select(Row)),
    });

    static JObject Row(PointRow row) => new()
    {
        ["azimuth_deg"] = row.AzimuthDegrees,
        ["vv_dbsm"] = ScatteringMatrix.Dbsm(row.Converged.S[0, 0].VV),
        ["hh_dbsm"] = ScatteringMatrix.Dbsm(row.Converged.S[0, 0].HH),
        ["converged_tolerance_met"] = row.Converged.IsMet,
        ["tubes_rays"] = row.Tubes.Rays,
        ["tubes_ms"] = row.TubesMs,
        ["tubes_error_db"] = row.TubesError.ErrorDb,
        ["tubes_tolerance_met"] = row.Tubes.IsMet,
        ["points_for_tolerance"] = row.Enough?.Across,
        ["rays_ratio"] = row.Ratio,
        ["points"] = new JArray(row.Points.Select(points => new JObject
        {
            ["across_side"] = points.Across,
            ["rays"] = points.Rays,
            ["error_db_95"] = PointRow.BoundDb(points.Error),
            ["ms"] = points.Times.Median,
        })),
    };
}
