using System.IO;
using System.Linq;
using Glint.Core;
using Newtonsoft.Json.Linq;

namespace Glint.Cli;

/// <summary>
/// A benchmark's figures as JSON. Times are in milliseconds, and medians unless the name says lowest. A missing figure
/// is null.
/// </summary>
static class BenchJson
{
    public static void Write(Stream stream, BenchResult result)
    {
        JsonText.Write(stream, Root(result));
    }

    static JObject Root(BenchResult result)
    {
        var root = new JObject
        {
            ["subject"] = result.Subject,
            ["scene"] = result.Scene,
            ["device"] = result.Device.Name,
            ["driver"] = result.Device.Driver,
            ["glint"] = GlintVersion.Text,
            ["rounds"] = result.Rounds,
            ["settings"] = Settings(result.Settings),
        };
        root.Merge(result.Sweep == null ? Poses(result) : Sweep(result.Sweep));
        root["peers"] = new JArray(result.Peers.SelectMany(peer => peer.Labels.Select(label =>
            Time(peer, label, result))));
        return root;
    }

    static JObject Sweep(SweepBench sweep)
    {
        var figures = new JObject
        {
            ["poses"] = sweep.Poses,
            ["rows"] = sweep.Rows,
            ["poses_a_second"] = Number(1000 / sweep.Wall.Median),
            ["wall_ms"] = Number(sweep.Wall.Median),
            ["wall_lowest_ms"] = Number(sweep.Wall.Lowest),
            ["kernels_ms"] = Number(sweep.Kernels.Median),
            ["kernels_lowest_ms"] = Number(sweep.Kernels.Lowest),
            ["wall_over_kernels"] = Number(sweep.Wall.Median / sweep.Kernels.Median),
            ["dispatches"] = sweep.Mean(pose => pose.Dispatches),
            ["round_trips"] = sweep.Mean(pose => pose.RoundTrips),
            ["bytes_uploaded"] = sweep.Mean(pose => pose.BytesUploaded),
            ["bytes_read_back"] = sweep.Mean(pose => pose.BytesReadBack),
        };
        foreach (var (name, _, time) in sweep.Parts)
            figures[$"{name}_ms"] = Number(time.Median);
        return figures;
    }

    static JObject Poses(BenchResult result)
    {
        var poses = result.Poses;
        var (sums, work) = (poses.First, poses.Statistics);
        return new JObject
        {
            ["pose_ms"] = Number(poses.Pose.Median),
            ["pose_lowest_ms"] = Number(poses.Pose.Lowest),
            ["pose_gpu_ms"] = Number(poses.PoseGpu.Median),
            ["pose_gpu_lowest_ms"] = Number(poses.PoseGpu.Lowest),
            ["pose_other_ms"] = Number(poses.Other.Median),
            ["trace_ms"] = Number(poses.Trace.Median),
            ["trace_lowest_ms"] = Number(poses.Trace.Lowest),
            ["readback_ms"] = Number(poses.ReadBack.Median),
            ["gather_ms"] = Number(poses.FirstGather.Median),
            ["build_ms"] = Number(poses.Build.Median),
            ["build_lowest_ms"] = Number(poses.Build.Lowest),
            ["upload_ms"] = Number(poses.FirstUpload.Median),
            ["first_pose_ms"] = Number(poses.FirstPose.Median),
            ["next_gather_ms"] = Number(poses.Gather.Median),
            ["next_build_and_upload_ms"] = Number(poses.Upload.Median),

            ["objects"] = sums.Statistics.Objects,
            ["triangles"] = sums.Statistics.Triangles,
            ["rays_emitted"] = sums.RaysEmitted,
            ["rays_hit"] = sums.RaysHit,
            ["rays_received"] = sums.RaysReceived,
            ["bounces"] = sums.Bounces,
            ["segments"] = sums.Segments,
            ["path_length_m"] = sums.PathLengthMeters,
            ["in_phase"] = sums.InPhase,
            ["quadrature"] = sums.Quadrature,
            ["amplitude"] = sums.Amplitude,

            ["nodes_visited"] = result.NodesVisited,
            ["pairs_tested"] = result.PairsTested,
            ["tiles_traced"] = work.TilesTraced,
            ["tiles_skipped"] = work.TilesSkipped,
            ["dispatches"] = work.Dispatches,
            ["trees_built"] = sums.Statistics.BvhsBuilt,
            ["triangles_built"] = sums.Statistics.TrianglesBuilt,
            ["bytes_hashed"] = work.BytesHashed,
            ["bytes_hashed_beside"] = work.BytesHashedBeside,
            ["first_bytes_uploaded"] = sums.Statistics.BytesUploaded,
            ["bytes_uploaded"] = work.BytesUploaded,
            ["bytes_read_back"] = work.BytesReadBack,
            ["bytes_on_device"] = work.BytesOnDevice,

            ["errors"] = result.Errors == null ? null : Errors(result.Errors),
            ["rays_gpu_ms"] = result.Clutter == null ? null : Number(result.Clutter.Rays.Median),
            ["clutter"] = result.Clutter == null ? null : new JArray(result.Clutter.Rows.Select(Clutter)),
        };
    }

    static JObject Settings(RadarSettings settings) => new()
    {
        ["frequency_hz"] = settings.FrequencyHz,
        ["rays_across"] = settings.RaysAcross,
        ["rays_down"] = settings.RaysDown,
        ["max_bounces"] = settings.MaxBounces,
        ["region"] = settings.Region.IsWhole
            ? null
            : new JArray(settings.Region.Left, settings.Region.Bottom, settings.Region.Width, settings.Region.Height),
    };

    static JObject Errors(ReferenceCheck errors) => new()
    {
        ["rays_judged"] = errors.Reference.RaysEmitted,
        ["rays_hit"] = errors.Hits,
        ["rays_hit_judge"] = errors.Reference.RaysHit,
        ["bounces"] = errors.Bounces,
        ["bounces_judge"] = errors.Reference.Bounces,
        ["path_length_relative"] = errors.PathLengthRelative,
        ["amplitude"] = errors.Amplitude,
        ["amplitude_relative"] = errors.AmplitudeRelative,
        ["amplitude_judge"] = errors.Reference.Amplitude,
        ["phase_rad"] = errors.Phase,
    };

    static JObject Clutter(ClutterTime row) => new()
    {
        ["what"] = row.What,
        ["facets"] = row.Facets,
        ["lit_fraction"] = row.Echo.LitFraction,
        ["sum_ms"] = Number(row.Wall.Median),
        ["sum_lowest_ms"] = Number(row.Wall.Lowest),
        ["sum_gpu_ms"] = Number(row.Kernels.Median),
        ["sum_gpu_lowest_ms"] = Number(row.Kernels.Lowest),
    };

    static JObject Time(Peer peer, string label, BenchResult result)
    {
        var starts = peer.SeriesOf(label);
        return new JObject
        {
            ["name"] = peer.Name,
            ["command"] = peer.Command,
            ["time"] = label,
            ["starts"] = starts.Count,
            ["median_ms"] = Number(starts.Median),
            ["lowest_ms"] = Number(starts.Lowest),
            ["over_pose"] = Number(starts.Median / result.Pose.Median),
            ["lowest_over_lowest_pose"] = Number(starts.Lowest / result.Pose.Lowest),
            ["over_pose_gpu"] = Number(starts.Median / result.Kernels.Median),
            ["lowest_over_lowest_pose_gpu"] = Number(starts.Lowest / result.Kernels.Lowest),
            ["last_line"] = peer.LastLine,
        };
    }

    static JToken Number(double value) => double.IsFinite(value) ? value : JValue.CreateNull();
}
