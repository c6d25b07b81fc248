using System.Collections.Generic;
using Glint.Editor;

namespace Glint.Cli;

/// <summary>A published experiment: a sweep of a stored scene, and its published table.</summary>
/// <param name="Name">Name in file names and markers.</param>
/// <param name="Published">
/// The table's file without its extension; null if the publication only says that nothing returned.
/// </param>
/// <param name="Scene">Scene of the project.</param>
/// <param name="Options">Options of glint sweep.</param>
sealed record Experiment(string Name, string Title, string Published, string Scene, params string[] Options)
{
    static readonly string[] s_snapshots = [Editor.Options.Snapshots.Flag, "1:10"],
        s_ship = [Editor.Options.Target.Flag, "Ship", Editor.Options.Angles.Flag, "0:360:15"];

    public static readonly Experiment CornerReflector = new("corner-reflector", "Corner reflector",
        "table_a2_corner_reflector", "Scenes/CornerReflector.unity",
        Editor.Options.Target.Flag, "Corner Reflector", Editor.Options.Angles.Flag, "0:45:1");

    public static readonly Experiment ShipInFreeSpace =
        new("ship-free-space", "Ship in free space", "table_a3_ship_free_space", "Scenes/ShipFreeSpace.unity", s_ship);

    /// <summary>Each stored sea without a ship, and the ship on one of its snapshots.</summary>
    public static IReadOnlyList<(Experiment Sea, Experiment Ship)> Seas { get; } =
    [
        (new("sea-state-5", "Sea state 5", null, "Scenes/SeaState5.unity", s_snapshots),
            new("ship-sea-state-5", "Ship on sea state 5", "table_a4_ship_ss5", "Scenes/ShipSeaState5.unity", s_ship)),
        (new("sea-state-6", "Sea state 6", "table_a1_ocean_ss6", "Scenes/SeaState6.unity", s_snapshots),
            new("ship-sea-state-6", "Ship on sea state 6", "table_a5_ship_ss6", "Scenes/ShipSeaState6.unity", s_ship)),
    ];

    /// <summary>All experiments, in the order of the publication.</summary>
    public static IReadOnlyList<Experiment> All { get; } =
        [CornerReflector, Seas[0].Sea, Seas[1].Sea, ShipInFreeSpace, Seas[0].Ship, Seas[1].Ship];

    /// <summary>The sweep as a command line.</summary>
    public CommandLine Line => CommandLine.Parse(Commands.Sweep, [Scene, .. Options]);
}
