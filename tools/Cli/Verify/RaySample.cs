using System;
using Glint.Core;

namespace Glint.Cli;

/// <summary>
/// Rays to compare, spread evenly over the picture, and over the rays received: about so many of each.
/// </summary>
sealed class RaySample
{
    readonly int _every, _everyReceived;
    long _seen, _seenReceived;

    public RaySample(RadarSettings settings, long received, int count)
    {
        _everyReceived = Every(received, count);
        _every = Every(settings.RaysEmitted, count);
        // No step that would take the same columns from every row.
        int width = settings.TracedRegion.Width;
        while (Divisor(_every, width) > 1)
            _every++;
    }

    /// <summary>Those among the rays, which follow the rays asked about before.</summary>
    public RayData[] Of(RayData[] rays) => Array.FindAll(rays, IsTaken);

    bool IsTaken(RayData ray)
    {
        bool isTaken = _seen++ % _every == 0;
        return ray.IsReceived && _seenReceived++ % _everyReceived == 0 || isTaken;
    }

    static int Every(long all, int count) => (int)Math.Max(1, (all + count - 1) / count);

    static int Divisor(int a, int b) => b == 0 ? a : Divisor(b, a % b);
}
