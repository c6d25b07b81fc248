using System;
using System.Diagnostics;
using System.Threading;
using UnityEngine;

namespace Glint.Host;

/// <summary>The time of the frame in seconds, in double, for UnityEngine.Time.</summary>
internal static class Clock
{
    // Unity uses this value for the first frame, which has no predecessor.
    const double FirstFrameSeconds = 0.02;

    static readonly Stopwatch _sinceStartup = Stopwatch.StartNew();
    static double _lastFrameAt;
    static double _levelLoadedAt;

    internal static double Time { get; private set; }
    internal static double UnscaledTime { get; private set; }
    internal static double Delta { get; private set; }
    internal static double UnscaledDelta { get; private set; }
    internal static double FixedTime { get; private set; }
    internal static int Frame { get; private set; }
    internal static bool InFixedStep { get; private set; }
    internal static double FixedDelta { get; set; } = 0.02;
    internal static double MaximumDelta { get; set; } = 1.0 / 3.0;
    internal static double Scale { get; set; } = 1.0;

    /// <summary>Fixed duration of each frame in seconds; 0 for real time.</summary>
    internal static double CaptureDelta { get; set; }

    internal static double SinceStartup => _sinceStartup.Elapsed.TotalSeconds;

    internal static double SinceLevelLoad => Time - _levelLoadedAt;

    internal static void Restart()
    {
        Time = UnscaledTime = Delta = UnscaledDelta = FixedTime = 0.0;
        _levelLoadedAt = 0.0;
        Frame = 0;
        InFixedStep = false;
    }

    internal static void Advance()
    {
        WaitForFrameRate();
        double now = SinceStartup;
        double real = Frame == 0 ? FirstFrameSeconds : now - _lastFrameAt;
        _lastFrameAt = now;
        Frame++;
        UnscaledDelta = CaptureDelta > 0.0 ? CaptureDelta : real;
        Delta = (CaptureDelta > 0.0 ? CaptureDelta : Math.Min(real, MaximumDelta)) * Scale;
        UnscaledTime += UnscaledDelta;
        Time += Delta;
    }

    /// <summary>Whether another fixed step fits before the frame's time; fixed steps lag behind, never ahead.</summary>
    internal static bool NextFixedStep()
    {
        InFixedStep = FixedTime + FixedDelta <= Time;
        if (InFixedStep)
            FixedTime += FixedDelta;
        return InFixedStep;
    }

    internal static void MarkLevelLoad() => _levelLoadedAt = Time;

    static void WaitForFrameRate()
    {
        if (Application.targetFrameRate <= 0 || Frame == 0)
            return;
        double wait = _lastFrameAt + 1.0 / Application.targetFrameRate - SinceStartup;
        if (wait > 0.0)
            Thread.Sleep(TimeSpan.FromSeconds(wait));
    }
}
