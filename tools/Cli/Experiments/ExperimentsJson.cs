using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using Newtonsoft.Json.Linq;

namespace Glint.Cli;

/// <summary>
/// The figures of glint experiments as JSON: angles in degrees, amplitudes linear. Lists of a sea are in the order of
/// its times.
/// </summary>
static class ExperimentsJson
{
    public static void Write(Stream stream, ExperimentsResult result)
    {
        JsonText.Write(stream, new JObject
        {
            ["device"] = result.Device.Name,
            ["driver"] = result.Device.Driver,
            ["glint"] = GlintVersion.Text,
            ["elapsed_s"] = result.Elapsed.TotalSeconds,
            ["sweeps"] = new JArray(result.Sweeps.Select(Sweep)),
            ["ships"] = new JArray(result.Ships.Select(Ship)),
            ["seas"] = new JArray(result.Seas.Select(Family)),
        });
    }

    static JObject Sweep(SweepResult sweep) => new()
    {
        ["name"] = sweep.Experiment.Name,
        ["arguments"] = new JArray(sweep.Experiment.Options.Prepend(sweep.Experiment.Scene)),
        ["published"] = sweep.Published == null ? null : new JArray(sweep.Published.Select(Row)),
        ["rows"] = new JArray(sweep.Rows.Select(Row)),
    };

    static JObject Ship(SnapshotsResult ship) => new()
    {
        ["name"] = ship.Name,
        ["published"] = new JArray(ship.Published.Select(Row)),
        ["rows"] = new JArray(ship.Rows.Select(Row)),
    };

    static JObject Row(PublishedRow row) => new()
    {
        ["step"] = row.Step,
        ["amplitude"] = row.Amplitude,
        ["rays_received"] = row.RaysReceived,
        ["rays_hit"] = row.RaysHit,
    };

    static JObject Row(SweepRow row) => new()
    {
        ["snapshot"] = row.Pose.Snapshot,
        ["angle_deg"] = row.Pose.AngleDegrees,
        ["amplitude"] = row.Result.Amplitude,
        ["rays_received"] = row.Result.RaysReceived,
        ["rays_hit"] = row.Result.RaysHit,
        ["sampling_error"] = row.Result.SamplingError,
        ["undersampled"] = row.Result.Undersampled,
    };

    static JObject Family(SeaFamily family) => new()
    {
        ["sea"] = family.Sea,
        ["is_stored"] = family.IsStored,
        ["wind_m_s"] = family.First.Waves.WindSpeed,
        ["choppiness"] = family.First.Waves.Choppiness,
        ["wave_height_m"] = family.First.Waves.SignificantWaveHeight,
        ["share_returning"] = family.Share,
        ["seeds"] = new JArray(family.Trials.Select(trial => new JObject
        {
            ["seed"] = trial.Waves.Seed,
            ["height_factor"] = trial.Waves.HeightFactor,
            ["returning"] = trial.ReturningSnapshots,
            ["rays_received"] = new JArray(trial.Snapshots.Select(snapshot => snapshot.RaysReceived)),
            ["rays_hit"] = new JArray(trial.Snapshots.Select(snapshot => snapshot.RaysHit)),
            ["amplitude"] = new JArray(trial.Snapshots.Select(snapshot => snapshot.Amplitude)),
        })),
    };
}
