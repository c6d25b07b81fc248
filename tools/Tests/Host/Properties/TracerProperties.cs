using System;
using System.Linq;
using FsCheck;
using FsCheck.Fluent;
using Glint.Core;
using Glint.Reference;
using Glint.Tests;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>Properties of every scene. A counterexample is reduced before it is reported.</summary>
[Category("Slow")]
public sealed class TracerProperties
{
    const double LengthTolerance = 1e-5; // m

    [Test]
    public void Trace_AnyScene_EveryRayIsTheReferencesOrPassesAnEdge([Values] bool asSoftware)
    {
        using var tracer = new RayTracer(TestKernels.Trace, "test", asSoftware);
        long rays = 0, received = 0, atEdge = 0;
        ForAll(RandomScenes.Certain, 150, scene =>
        {
            var comparison = Compare(tracer, scene);
            rays += comparison.Rays;
            received += comparison.KernelSums.RaysReceived;
            atEdge += comparison.AtEdge;
            return (comparison.Wrong == 0).Label(Describe(comparison));
        });
        TestContext.Out.WriteLine($"{rays} rays, {received} received, {atEdge} at edges");
        // Scenes without received rays would show little.
        Assert.That(received, Is.GreaterThan(rays / 50));
    }

    [Test]
    public void Trace_AnyScene_SumsDoNotDependOnDispatchesOrTheOrderOfInstances([Values] bool asSoftware)
    {
        using var tracer = new RayTracer(TestKernels.Trace, "test", asSoftware);
        ForAll(RandomScenes.Any, 80, scene =>
        {
            tracer.TilesADispatch = 0;
            var once = Trace(tracer, scene);
            tracer.TilesADispatch = 7;
            var slices = Trace(tracer, scene);
            var reversed = Trace(tracer, scene with { Bodies = [.. scene.Bodies.Reverse()] });
            return AreSame(once, slices).Label("in dispatches of 7 tiles")
                .And(AreSame(once, reversed).Label("instances in reverse order"));
        });
    }

    static RayComparison Compare(RayTracer tracer, RandomScene scene)
    {
        var comparison = new RayComparison(new RadarPose(scene.Scene, scene.Settings, scene.View), LengthTolerance);
        comparison.Add(tracer.Trace(new RadarPose(scene.Scene, TestRadar.WithoutError(scene.Settings), scene.View),
            RayReadback.All).Rays);
        return comparison;
    }

    static RadarResult Trace(RayTracer tracer, RandomScene scene)
    {
        return tracer.Trace(new RadarPose(scene.Scene, scene.Settings, scene.View), RayReadback.None);
    }

    static bool AreSame(RadarResult a, RadarResult b) =>
        a.RaysHit == b.RaysHit && a.RaysReceived == b.RaysReceived && a.Bounces == b.Bounces
        && a.PhaseHistogram.SequenceEqual(b.PhaseHistogram)
        && Bits(a.InPhase) == Bits(b.InPhase) && Bits(a.Quadrature) == Bits(b.Quadrature)
        && Bits(a.PathLengthMeters) == Bits(b.PathLengthMeters)
        && Bits(a.SamplingError.Value) == Bits(b.SamplingError.Value)
        && Bits(a.LargestPathStep.Value) == Bits(b.LargestPathStep.Value)
        && a.Undersampled == b.Undersampled;

    static long Bits(double value) => BitConverter.DoubleToInt64Bits(value);

    static string Describe(RayComparison comparison) => $"{comparison.Wrong} of {comparison.Rays} rays wrong, "
        + $"{comparison.AtEdge} at edges; the first wrong ones:\n"
        + string.Concat(comparison.WrongRays.Take(3).Select(pair => FormattableString.Invariant(
            $"  pixel {pair.Kernel.Pixel % RandomScene.RaysAcross}, {pair.Kernel.Pixel / RandomScene.RaysAcross}: kernel {pair.Kernel.Bounces} bounces, {(pair.Kernel.IsReceived ? "received" : "lost")}, {pair.Kernel.RefinedPathLength:R} m; reference {pair.Reference.Bounces} bounces, {(pair.Reference.Received ? "received" : "lost")}, {pair.Reference.LengthToEnd:R} m\n")));

    // The scenes are always the same. A longer run with other seeds searches for rare failures, so that test runs
    // remain reproducible.
    static void ForAll(Arbitrary<RandomScene> scenes, int count, Func<RandomScene, Property> holds) =>
        Prop.ForAll(scenes, holds).Check(Config.QuickThrowOnFailure.WithMaxTest(count).WithReplay(1, 1));
}
