using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Vulkan;

namespace Glint.Cli;

/// <summary>Results of glint experiments.</summary>
sealed class ExperimentsResult
{
    public DeviceInfo Device { get; init; }

    /// <summary>Results in the order of <see cref="Experiment.All"/>.</summary>
    public List<SweepResult> Sweeps { get; } = [];

    /// <summary>The ship's rays that each sea blocks and the rays that it adds, angle by angle.</summary>
    public IEnumerable<(Experiment Ship, IReadOnlyList<SeaShare> Angles)> Shares
    {
        get
        {
            var freeSpace = Sweeps.Single(sweep => sweep.Experiment == Experiment.ShipInFreeSpace);
            return Experiment.Seas.Select(pair => (pair.Ship, (IReadOnlyList<SeaShare>)[.. SeaShare.Of(freeSpace,
                Sweeps.Single(sweep => sweep.Experiment == pair.Ship))]));
        }
    }

    /// <summary>The radar's pictures of the corner reflector at <see cref="ReflectorPicture.Angles"/>.</summary>
    public IReadOnlyList<RadarPreviewImage> Reflector { get; set; } = [];

    /// <summary>The ship on every snapshot of each stored sea.</summary>
    public List<SnapshotsResult> Ships { get; } = [];

    /// <summary>Families of each sea; the first has the stored wind and choppiness.</summary>
    public List<SeaFamily> Seas { get; } = [];

    /// <summary>Duration of the whole command.</summary>
    public TimeSpan Elapsed { get; set; }

    /// <summary>Published number of a sea's snapshots that returned rays, and the number of snapshots.</summary>
    /// <param name="sea">Name of the stored sea.</param>
    public (int ReturningSnapshots, int Snapshots) PublishedReturns(string sea)
    {
        var sweep = Sweeps.Single(sweep => Path.GetFileNameWithoutExtension(sweep.Experiment.Scene) == sea);
        return (sweep.Published?.Count(row => row.RaysReceived > 0) ?? 0, sweep.Rows.Count);
    }
}
