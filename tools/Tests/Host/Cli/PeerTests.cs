using System;
using System.Diagnostics;
using System.Threading;
using Glint.Cli;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>Other programs that a benchmark times: their output, their exit, and their termination.</summary>
public sealed class PeerTests
{
    [TestCase("frame 81.3 ms", "frame", 81.3)]
    [TestCase("dispatch 784.500 ms", "dispatch", 784.5)]
    [TestCase("bvh 24311 nodes 12.5 ms", "bvh", 12.5)]
    [TestCase("build time: 60 ms.", "build time", 60)]
    [TestCase("  trace = 1.5e-2 ms (GPU)", "trace", 0.015)]
    [TestCase("7 ms", "time", 7)]
    public void Output_OfALine_IsATimeByItsFirstWords(string line, string label, double ms)
    {
        var output = new PeerOutput(line);
        Assert.That(output.Labels, Is.EqualTo(new[] { label }));
        Assert.That(output.Median(label), Is.EqualTo(ms));
    }

    [Test]
    public void Output_OfManyLines_GivesTheMedianOfEachTime()
    {
        var output = new PeerOutput("some GPU\nbuild 60 ms\nframe 9 ms\nframe 3 ms\nframe 1 ms\n"
            + "frame 4 ms, alone 2 ms\n\nhit 5 ms2 12 msec\n");
        Assert.That(output.Labels, Is.EqualTo(new[] { "build", "frame", "alone" }));
        Assert.That(output.Median("frame"), Is.EqualTo(3.5));
        Assert.That(output.LastLine, Is.EqualTo("hit 5 ms2 12 msec"));
    }

    [Test]
    public void Starts_ThatCount_AreKept_WarmUpsAreNot()
    {
        string file = System.IO.Path.GetTempFileName();
        try
        {
            // The n-th start prints 10 n.
            var peer = new Peer(PeerCommand.Parse("Counter=echo x >> {scene}; echo frame $(wc -l < {scene})0 ms"));
            peer.Run(file, false, default);
            peer.Run(file, true, default);
            peer.Run(file, true, default);
            peer.Run(file, true, default);

            var starts = peer.SeriesOf("frame");
            Assert.That((starts.Count, starts.Median, starts.Lowest), Is.EqualTo((3, 30.0, 20.0)));
        }
        finally
        {
            System.IO.File.Delete(file);
        }
    }

    [TestCase("false", "ended with exit code 1: without a word")]
    [TestCase("echo no such scene >&2; exit 3", "ended with exit code 3: no such scene")]
    [TestCase("echo hit 12",
        "printed no time, which is a number before \" ms\" as in \"frame 81.3 ms\"; its last line: hit 12")]
    public void Peer_ThatFails_SaysSoByName(string command, string message)
    {
        var error =
            Assert.Throws<GlintException>(() => new Peer(PeerCommand.Parse("P=" + command)).Run(null, true, default));
        Assert.That(error.Message, Is.EqualTo("--peer P: " + message));
    }

    [Test]
    public void Peer_WhenCancelled_IsEndedAtOnce()
    {
        using var source = new CancellationTokenSource(TimeSpan.FromMilliseconds(200));
        var watch = Stopwatch.StartNew();
        Assert.Throws<OperationCanceledException>(() => new Peer(PeerCommand.Parse("Sleeper=sleep 60; echo frame 1 ms"))
            .Run(null, true, source.Token));
        Assert.That(watch.Elapsed, Is.LessThan(TimeSpan.FromSeconds(20)));
    }

    [TestCase(new double[0], double.NaN, double.NaN)]
    [TestCase(new[] { 5.0 }, 5.0, 5.0)]
    [TestCase(new[] { 9.0, 1, 4 }, 4.0, 1.0)]
    [TestCase(new[] { 9.0, 1, 4, 3 }, 3.5, 1.0)]
    public void Series_HasAMedianAndALowest(double[] values, double median, double lowest)
    {
        var series = new Series(values);
        Assert.That(series.Median, Is.EqualTo(median));
        Assert.That(series.Lowest, Is.EqualTo(lowest));
    }
}
