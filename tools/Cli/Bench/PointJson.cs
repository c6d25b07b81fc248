using System.IO;
using System.Linq;
using Glint.Core;
using Newtonsoft.Json.Linq;

namespace Glint.Cli;

/// <summary>
/// Rays of ray tubes and of point sampling as JSON. Times are in milliseconds, medians over the grids.
/// </summary>
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
        ["grids"] = result.Grids,
        ["directions"] = new JArray(result.Rows.Select(Row)),
    });

    static JObject Row(PointRow row) => new()
    {
        ["azimuth_deg"] = row.AzimuthDegrees,
        ["vv_dbsm"] = ScatteringMatrix.Dbsm(row.Converged.VV),
        ["hh_dbsm"] = ScatteringMatrix.Dbsm(row.Converged.HH),
        ["converged_error_db_95"] = PointRow.BoundDb(row.ConvergedError),
        ["is_reached"] = row.IsReached,
        ["rays_ratio"] = row.Ratio,
        ["tubes"] = new JArray(row.Tubes.Select(tubes => Of(row, tubes, "tolerance_db"))),
        ["points"] = new JArray(row.Points.Select(points => Of(row, points, "across_side"))),
    };

    static JObject Of(PointRow row, Sampling sampling, string setting) => new()
    {
        [setting] = sampling.Setting,
        ["rays"] = sampling.Rays,
        ["error_db_95"] = PointRow.BoundDb(row.ErrorOf(sampling)),
        ["ms"] = sampling.Times.Median,
    };
}
