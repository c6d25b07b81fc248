using System;
using Glint.Core;

namespace Glint.Cli;

/// <summary>
/// A sample of the picture's rays and one of the received rays, each evenly spread and of about the same size.
/// </summary>
sealed class RaySample
{
    readonly long _every, _everyReceived;
    long _seen, _seenReceived;

    public RaySample(RadarSettings settings, long received, int count)
    {
        _everyReceived = Every(received, count);
        _every = Every(settings.RaysEmitted, count);
        // A step without a common divisor with the width, so that the rows' columns differ.
        int width = settings.TracedRegion.Width;
        while (Divisor(_every, width) > 1)
            _every++;
    }

    /// <summary>The sample's rays of a block. Blocks are passed in the order of the picture.</summary>
    public RayData[] Of(RayData[] rays) => Array.FindAll(rays, IsTaken);

    bool IsTaken(RayData ray)
    {
        bool isTaken = _seen++ % _every == 0;
        return ray.IsReceived && _seenReceived++ % _everyReceived == 0 || isTaken;
    }

    static long Every(long all, int count) => Math.Max(1, (all + count - 1) / count);

    static long Divisor(long a, long b) => b == 0 ? a : Divisor(b, a % b);
}
