using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using Glint.Reference;
using Glint.Vulkan;
using Newtonsoft.Json.Linq;

namespace Glint.Cli;

/// <summary>The result of glint verify.</summary>
sealed record VerifyResult(LoadedScene LoadedScene, DeviceInfo Device, RadarResult Whole, RayComparison Comparison)
{
    /// <summary>The result as JSON: lengths in metres, phases in radians.</summary>
    public void WriteJson(Stream stream)
    {
        JsonText.Write(stream, Root());
    }

    JObject Root() => new()
    {
        ["subject"] = LoadedScene.Name,
        ["scene"] = LoadedScene.Scene,
        ["device"] = Device.Name,
        ["driver"] = Device.Driver,
        ["glint"] = GlintVersion.Text,
        ["rays_emitted"] = Whole.RaysEmitted,
        ["rays_received"] = Whole.RaysReceived,
        ["rays_compared"] = Comparison.Rays,
        ["rays_same"] = Comparison.Same,
        ["rays_at_edges"] = Comparison.AtEdge,
        ["rays_wrong"] = Comparison.Wrong,
        ["received_compared"] = Comparison.KernelSums.RaysReceived,
        ["length_difference_m"] = Comparison.LargestLengthDifference,
        ["length_difference_rms_m"] = Comparison.RmsLengthDifference,
        ["length_tolerance_m"] = VerifyCommand.LengthTolerance,
        ["phase_difference_rad"] = Comparison.LargestPhaseDifference,
        ["amplitude"] = Comparison.KernelSums.Amplitude,
        ["amplitude_judge"] = Comparison.ReferenceSums.Amplitude,
        ["wrong"] = new JArray(Comparison.WrongRays.Select(pair => new JObject
        {
            ["pixel"] = pair.Kernel.Pixel,
            ["bounces"] = pair.Kernel.Bounces,
            ["bounces_judge"] = pair.Reference.Bounces,
            ["received"] = pair.Kernel.IsReceived,
            ["received_judge"] = pair.Reference.Received,
            ["length_m"] = pair.Kernel.RefinedPathLength,
            ["length_judge_m"] = pair.Reference.LengthToEnd,
        })),
    };
}
