using System.Collections.Generic;
using Glint.Reference;
using Glint.Vulkan;

namespace Glint.Cli;

/// <summary>All that the accuracy benchmark found out.</summary>
sealed class AccuracyResult
{
    public DeviceInfo Device { get; init; }
    public int Rounds { get; init; }

    /// <summary>Scene by scene, few rays first.</summary>
    public List<AccuracyRow> Rows { get; } = [];

    /// <summary>Of the published number of rays.</summary>
    public List<AccuracyPrecision> Precision { get; } = [];

    /// <summary>
    /// The scene in which pieces of work were left out or done otherwise; the first cost is that of a pose as it is.
    /// </summary>
    public AccuracyScene CostScene { get; set; }
    public List<AccuracyCost> Costs { get; } = [];
}
