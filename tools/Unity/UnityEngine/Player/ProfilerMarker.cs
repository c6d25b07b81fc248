using System;
using System.Diagnostics;

namespace Unity.Profiling;

/// <summary>Without effect in the host; the markers are for Unity's profiler.</summary>
public struct ProfilerMarker
{
    public ProfilerMarker(string name)
    {
    }

    [Conditional("ENABLE_PROFILER")]
    public void Begin()
    {
    }

    [Conditional("ENABLE_PROFILER")]
    public void End()
    {
    }

    public AutoScope Auto() => default;

    public struct AutoScope : IDisposable
    {
        public void Dispose()
        {
        }
    }
}
