using System.IO;
using System.Linq;
using Glint.Core;
using Newtonsoft.Json.Linq;

namespace Glint.Cli;

/// <summary>Ray tubes beside uniform rays as JSON. Times are medians in milliseconds.</summary>
static class TubeJson
{
    public static void Write(Stream stream, TubeResult result)
    {
        JsonText.Write(stream, new JObject
        {
            ["device"] = result.Device.Name,
            ["driver"] = result.Device.Driver,
            ["glint"] = GlintVersion.Text,
            ["rounds"] = result.Rounds,
            ["poses_together"] = result.PosesTogether,
            ["scenes"] = new JArray(result.Scenes.Select(Scene)),
        });
    }

    static JObject Scene(TubeScene scene) => new()
    {
        ["name"] = scene.Scene.Name,
        ["converged_amplitude"] = scene.Converged.Magnitude,
        ["converged_amplitude_uncertainty"] = scene.Uncertainty,
        ["converged_phase_rad"] = scene.Converged.Phase,
        ["tubes"] = new JArray(scene.Tubes.Select(row => Row(row, "tolerance_db", row.Settings.ToleranceDb))),
        ["together"] = scene.Together == null ? null : Row(scene.Together, "tolerance_db", scene.Together.Settings.ToleranceDb),
        ["uniform"] = new JArray(scene.Uniform.Select(row => Row(row, "rays_across", row.Settings.RaysAcross))),
    };

    static JObject Row(TubeRow row, string name, JToken value) => new()
    {
        [name] = value,
        ["rays"] = row.Rays,
        ["trace_ms"] = row.Times.Median,
        ["kernels_ms"] = row.KernelTimes.Count > 0 ? row.KernelTimes.Median : null,
        ["normalised_amplitude"] = row.Result.NormalisedAmplitude,
        ["amplitude_error_relative"] = row.Error,
        ["sampling_error"] = row.Result.SamplingError,
        ["undersampled"] = row.Result.Undersampled,
    };
}
