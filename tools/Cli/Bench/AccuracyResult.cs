using System.Collections.Generic;
using Glint.Reference;
using Glint.Vulkan;

namespace Glint.Cli;

/// <summary>Results of the accuracy benchmark.</summary>
sealed class AccuracyResult
{
    public DeviceInfo Device { get; init; }
    public int Rounds { get; init; }

    /// <summary>Rows by scene, in ascending number of rays.</summary>
    public List<AccuracyRow> Rows { get; } = [];

    /// <summary>Precision at the published number of rays.</summary>
    public List<AccuracyPrecision> Precision { get; } = [];

    /// <summary>
    /// Scene in which parts of the work were left out or changed. Its first cost is that of an unchanged pose.
    /// </summary>
    public AccuracyScene CostScene { get; set; }
    public List<AccuracyCost> Costs { get; } = [];
}
