using Glint.Core;

namespace Glint.Cli;

/// <summary>Ray tubes at one tolerance, or one number of uniform rays, in a <see cref="TubeScene"/>.</summary>
/// <param name="error">Relative error of the amplitude.</param>
sealed class TubeRow(RadarSettings settings, RadarResult result, Series times, Series kernelTimes, double error)
{
    public RadarSettings Settings { get; } = settings;
    public RadarResult Result { get; } = result;

    /// <summary>Time of tracing and summing, with the scene already on the device.</summary>
    public Series Times { get; } = times;

    /// <summary>Device time of the kernels in them; none on a device without a clock.</summary>
    public Series KernelTimes { get; } = kernelTimes;

    /// <summary>Relative error of the amplitude.</summary>
    public double Error { get; } = error;

    /// <summary>Rays of the pose, with the sub-rays of the sampling error.</summary>
    public long Rays => Result.RaysEmitted + Result.Statistics.SubRays;
}
