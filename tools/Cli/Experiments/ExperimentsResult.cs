using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Vulkan;

namespace Glint.Cli;

/// <summary>All that glint experiments found out.</summary>
sealed class ExperimentsResult
{
    public DeviceInfo Device { get; init; }

    /// <summary>In the order of <see cref="Experiment.All"/>.</summary>
    public List<SweepResult> Sweeps { get; } = [];

    /// <summary>What each sea takes from the ship's rays and adds to them, angle by angle.</summary>
    public IEnumerable<(Experiment Ship, IReadOnlyList<SeaShare> Angles)> Shares
    {
        get
        {
            var freeSpace = Sweeps.Single(sweep => sweep.Experiment == Experiment.ShipInFreeSpace);
            return Experiment.Seas.Select(pair => (pair.Ship, (IReadOnlyList<SeaShare>)[.. SeaShare.Of(freeSpace,
                Sweeps.Single(sweep => sweep.Experiment == pair.Ship))]));
        }
    }

    /// <summary>What the radar sees of the corner reflector at <see cref="ReflectorPicture.Angles"/>.</summary>
    public IReadOnlyList<RadarPreviewImage> Reflector { get; set; } = [];

    /// <summary>The ship on every snapshot of each stored sea.</summary>
    public List<SnapshotsResult> Ships { get; } = [];

    /// <summary>Sea by sea, the stored wind and choppiness first.</summary>
    public List<SeaFamily> Seas { get; } = [];

    /// <summary>Of all of it.</summary>
    public TimeSpan Elapsed { get; set; }

    /// <summary>Snapshots of a sea that returned anything as published, and of how many.</summary>
    /// <param name="sea">Name of the stored sea.</param>
    public (int ReturningSnapshots, int Snapshots) PublishedReturns(string sea)
    {
        var sweep = Sweeps.Single(sweep => Path.GetFileNameWithoutExtension(sweep.Experiment.Scene) == sea);
        return (sweep.Published?.Count(row => row.RaysReceived > 0) ?? 0, sweep.Rows.Count);
    }
}
