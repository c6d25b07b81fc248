using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using Newtonsoft.Json.Linq;

namespace Glint.Cli;

/// <summary>
/// The accuracy benchmark's figures as JSON. Times are in milliseconds, and medians unless the name says lowest.
/// </summary>
static class AccuracyJson
{
    public static void Write(Stream stream, AccuracyResult result)
    {
        JsonText.Write(stream, new JObject
        {
            ["device"] = result.Device.Name,
            ["driver"] = result.Device.Driver,
            ["glint"] = GlintVersion.Text,
            ["rounds"] = result.Rounds,
            ["normal_rays"] = RadarResult.NormalRays,
            ["scenes"] = new JArray(result.Rows.GroupBy(row => row.Scene).Select(Scene)),
            ["precision"] = new JArray(result.Precision.Select(Precision)),
            ["cost_scene"] = result.CostScene.Name,
            ["costs"] = new JArray(result.Costs.Select(Cost)),
        });
    }

    static JObject Scene(IGrouping<AccuracyScene, AccuracyRow> rows)
    {
        var converged = rows.First().Converged;
        return new JObject
        {
            ["name"] = rows.Key.Name,
            ["converged_amplitude"] = converged.Sum.Magnitude,
            ["converged_amplitude_uncertainty"] = converged.Uncertainty,
            ["converged_phase_rad"] = converged.Sum.Phase,
            ["converged_hits"] = converged.Hits,
            ["poses"] = new JArray(rows.Select(Row)),
        };
    }

    static JObject Row(AccuracyRow row) => new()
    {
        ["rays_across"] = row.Settings.RaysAcross,
        ["rays_down"] = row.Settings.RaysDown,
        ["trace_ms"] = row.Times.Median,
        ["trace_lowest_ms"] = row.Times.Lowest,
        ["rays_hit"] = row.Result.RaysHit,
        ["rays_received"] = row.Result.RaysReceived,
        ["sub_rays"] = row.Result.Statistics.SubRays,
        ["amplitude"] = row.Result.Amplitude,
        ["normalised_amplitude"] = row.Result.NormalisedAmplitude,
        ["normalised_amplitude_error"] = row.AmplitudeError,
        ["sampling_error"] = row.Result.SamplingError,
        ["largest_path_step_wavelengths"] = row.Result.LargestPathStep,
        ["undersampled"] = row.Result.Undersampled,
        ["phase_error_rad"] = row.PhaseError,
        ["hits_error_relative"] = row.HitsError,
    };

    static JObject Precision(AccuracyPrecision row) => new()
    {
        ["scene"] = row.Scene.Name,
        ["rays_received"] = row.RaysReceived,
        ["received_difference"] = row.ReceivedDifference,
        ["hits_difference"] = row.HitsDifference,
        ["sum_difference"] = row.SumDifference,
        ["float32_lengths"] = new JArray(AccuracyPrecision.Float32Ranges.Zip(row.Float32Differences,
            (range, difference) => new JObject { ["farther_m"] = range, ["sum_difference"] = difference })),
    };

    static JObject Cost(AccuracyCost cost) => new()
    {
        ["what"] = cost.What,
        ["trace_ms"] = cost.Times.Median,
        ["trace_lowest_ms"] = cost.Times.Lowest,
        ["rays_received"] = cost.RaysReceived,
        ["sub_rays"] = cost.SubRays,
        ["sums_are_the_same"] = cost.IsSame,
    };
}
