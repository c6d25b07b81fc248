using System;
using System.Collections.Generic;
using Glint.Core;
using Glint.Editor;
using Glint.Host;
using Glint.Reference;

namespace Glint.Cli;

/// <summary>The command glint verify: compares rays of the kernel with the reference tracer.</summary>
sealed class VerifyCommand(Terminal terminal)
{
    /// <summary>
    /// Allowed difference of a received ray's length besides rounding, in metres: 0.002 rad at 10 GHz.
    /// </summary>
    public const double LengthTolerance = 1e-5;

    // Maximum number of the kernel's rays in memory: 100 MB.
    const int RaysAtOnce = 1 << 21;

    /// <returns>The report's lines, and the exit code: 1 if a ray is wrong.</returns>
    /// <exception cref="GlintException">A problem with a file, the scene or the device.</exception>
    /// <exception cref="OperationCanceledException">Stopped by the user.</exception>
    public (string[] Report, int ExitCode) Execute(CommandLine line, IProgressSink progress)
    {
        var json = OutputFile.Of(line, Options.Json);
        var loaded = LoadedScene.Open(line);
        try
        {
            var result = Verify(loaded, line.Get(Options.Rays), progress);
            json?.Write(result.WriteJson);
            string[] written = json == null ? [] : [$"written: {json.Path}"];
            return ([.. new VerifyReport(terminal).Lines(result), .. written], result.Comparison.Wrong == 0 ? 0 : 1);
        }
        finally
        {
            loaded.Radar.Release();
        }
    }

    static VerifyResult Verify(LoadedScene loaded, int raysToCompare, IProgressSink progress)
    {
        var radar = loaded.Radar;
        var pose = radar.Gather();
        var settings = pose.Settings;
        using var tracer = new RayTracer(radar.Kernel, loaded.Name);

        RadarResult whole = null;
        Step("kernel", progress, () => whole = tracer.Trace(pose, RayReadback.None, progress, progress.Cancel));
        var sample = new RaySample(settings, whole.RaysReceived, raysToCompare);
        var comparison = new RayComparison(pose, LengthTolerance);
        var bands = Bands(settings);
        progress.Start("kernel and reference", bands.Count);
        try
        {
            for (int i = 0; i < bands.Count; i++)
            {
                pose.Settings.Region = bands[i];
                var rays = tracer.Trace(pose, RayReadback.All, new Part(progress, 0, 2), progress.Cancel).Rays;
                comparison.Add(sample.Of(rays), new Part(progress, 1, 2), progress.Cancel);
                progress.Advance(i + 1, null);
            }
        }
        finally
        {
            progress.Finish();
        }
        return new VerifyResult(loaded, GraphicsDevice.Current.Info, whole, comparison);
    }

    // Blocks of rows of the region, each within the maximum number of rays.
    static List<RayRegion> Bands(RadarSettings settings)
    {
        var region = settings.TracedRegion;
        int rows = Math.Max(PictureTiles.Side, RaysAtOnce / region.Width);
        var bands = new List<RayRegion>();
        for (int row = 0; row < region.Height; row += rows)
            bands.Add(region with { Bottom = region.Bottom + row, Height = Math.Min(rows, region.Height - row) });
        return bands;
    }

    static void Step(string what, IProgressSink progress, Action work)
    {
        progress.Start(what, 1);
        try
        {
            work();
            progress.Advance(1, null);
        }
        finally
        {
            progress.Finish();
        }
    }
}
