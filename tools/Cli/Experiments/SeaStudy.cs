using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Cli;

/// <summary>
/// Counts the returning snapshots of seas: those like a stored one, and others with less and more wind and choppiness,
/// for several seeds.
/// </summary>
/// <param name="sea">A sea before the radar. It keeps its extent; waves replace its snapshots.</param>
sealed class SeaStudy(RadarController radar, Sea sea, IProgressSink progress)
{
    // Factors of the stored sea's wind and choppiness.
    static readonly (double wind, double choppiness)[] s_variants = [(1, 1), (0.8, 1), (1.25, 1), (1, 0), (1, 1.6)];

    /// <returns>The families; the first has the stored wind and choppiness.</returns>
    /// <exception cref="GlintException">A sea cannot be made or traced.</exception>
    /// <exception cref="OperationCanceledException">Stopped by the user.</exception>
    public IReadOnlyList<SeaFamily> Run(SeaRecipe stored, int seeds)
    {
        sea.Snapshots.Clear();
        var families = new List<SeaFamily>();
        int done = 0;
        progress.Start($"seas like {stored.Name}", s_variants.Length * seeds);
        try
        {
            foreach (var (wind, choppiness) in s_variants)
            {
                var trials = new List<SeaTrial>();
                foreach (int seed in Seeds(stored.Settings.Seed, seeds))
                {
                    var trial = Try(Like(stored, wind, choppiness, seed));
                    trials.Add(trial);
                    progress.Advance(++done, FormattableString.Invariant(
                        $"{trial.Waves.WindSpeed:0.##} m/s, choppiness {trial.Waves.Choppiness:0.##}, seed {seed}"));
                }
                families.Add(new SeaFamily(stored.Name, families.Count == 0, trials));
            }
        }
        finally
        {
            progress.Finish();
        }
        return families;
    }

    /// <summary>The stored seed, then the lowest others.</summary>
    public static IEnumerable<int> Seeds(int stored, int count) =>
        Enumerable.Range(1, count).Where(seed => seed != stored).Prepend(stored).Take(count);

    // The height factor is calculated for each sea, so that all are as high as the stored one.
    static SeaRecipe Like(SeaRecipe stored, double wind, double choppiness, int seed)
    {
        var settings = stored.Settings;
        settings.WindSpeed *= wind;
        settings.Choppiness *= choppiness;
        settings.Seed = seed;
        return new SeaRecipe(stored.Name, settings, stored.Times, stored.Tiles);
    }

    SeaTrial Try(SeaRecipe recipe)
    {
        var snapshots = new List<RadarResult>();
        sea.Waves = recipe.Settings;
        foreach (double time in recipe.Times)
        {
            sea.TimeSeconds = time;
            snapshots.Add(
                radar.Trace(RayReadback.None,
                    new Part(progress, snapshots.Count, recipe.Times.Count), progress.Cancel));
        }
        return new SeaTrial(recipe.Settings, snapshots);
    }
}
