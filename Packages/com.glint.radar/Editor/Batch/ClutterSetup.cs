using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>The sea of a scene and the rows that <c>glint clutter</c> computes of it.</summary>
    sealed class ClutterSetup
    {
        /// <summary>Fewest cells of a shape.</summary>
        public const int MinCells = 10;

        // In the words of conventions.md.
        const string Conventions = "sigma0 in dB of m2/m2, mean over the tile without speckle; azimuth of the radar 0 on "
            + "the -Z side and positive as a rotation about Y; angle to the wind 0 where the radar looks against it";

        readonly CommandLine _line;
        readonly Sea _sea;
        readonly IReadOnlyList<double?> _moments;
        readonly SceneGatherer _gatherer = new SceneGatherer();
        readonly double[] _grazing, _azimuths, _frequencies;

        /// <summary>The setup of a command line.</summary>
        /// <exception cref="GlintException">The scene cannot be opened, or its sea has no clutter.</exception>
        public ClutterSetup(CommandLine line)
        {
            _line = line;
            ScenePath = LoadedScene.OpenSceneFile(line.Input);
            _sea = SceneSearch.FindSea(line.Input);
            SwitchOn();
            Model = ClutterModel.Of(_sea.Clutter.Level);
            _moments = MomentsOf();
            (_azimuths, _frequencies) = (line.Get(ClutterOptions.Azimuth), line.Get(ClutterOptions.Frequency));
            Cell = line.Get(ClutterOptions.Cell);
            First = Show(_moments[0]);
            foreach (string warning in _gatherer.Warnings)
                Debug.LogWarning($"{line.Input}: {warning}");
            _grazing = GrazingOf(First.Clutter);
            CrossSectionPlan.CountOf((double)_moments.Count * _frequencies.Length * _azimuths.Length * _grazing.Length);
            Validate(First);
        }

        /// <summary>Asset path of the scene.</summary>
        public string ScenePath { get; }

        /// <summary>Name of the scene.</summary>
        public string Name => Path.GetFileNameWithoutExtension(ScenePath);

        /// <summary>The model that gives the mean echo; null for physics.</summary>
        public ClutterModel Model { get; }

        /// <summary>Size of a cell, metres, along the direction of the radar and across.</summary>
        public double2 Cell { get; }

        /// <summary>The sea at the first moment.</summary>
        public EndlessSea First { get; }

        /// <summary>Number of rows.</summary>
        public int Count => _moments.Count * _frequencies.Length * _azimuths.Length * _grazing.Length;

        /// <summary>What is asked of each row, in order. Shows the sea at its moment.</summary>
        public IEnumerable<(EndlessSea Sea, int? Snapshot, double Frequency, double Azimuth, double Grazing)> Rows()
        {
            foreach (double? moment in _moments)
            {
                var sea = Show(moment);
                int? snapshot = _sea.Snapshots.Count > 0 ? _sea.Snapshot : (int?)null;
                foreach (double frequency in _frequencies)
                    foreach (double azimuth in _azimuths)
                        foreach (double grazing in _grazing)
                            yield return (sea, snapshot, frequency, azimuth, grazing);
            }
        }

        /// <summary>The description of the run for results.json.</summary>
        public RunInfo Describe(DateTime startedUtc)
        {
            var info = RunDescription.OfMachine();
            (info.ScenePath, info.Command, info.TargetName) = (ScenePath, Batch.ArgumentsOf(_line), _sea.name);
            (info.Objects, info.Triangles) = (1, 2L * Waves.Cells * Waves.Cells);
            (info.StartedUtc, info.ElapsedMs) = (startedUtc, (DateTime.UtcNow - startedUtc).TotalMilliseconds);
            void Add(string name, double value, string unit) => info.Settings.Add(new RunSetting(name, value, unit));
            info.Settings.Add(new RunSetting("conventions", Conventions));
            info.Settings.Add(new RunSetting("level", ClutterModel.NameOf(_sea.Clutter.Level)));
            info.Settings.Add(new RunSetting("spectrum", Waves.Kind.ToString()));
            Add("wave_height", First.Clutter.LongWaves.SignificantWaveHeight, "m");
            Add("sea_state", First.Clutter.SeaState, "1");
            Add("clutter_wind", First.Clutter.ShortWaves.Wind, "m/s");
            var wind = First.Clutter.Wind;
            Add("wind_direction", math.degrees(Math.Atan2(wind.x, wind.z)), "deg");
            if (Waves.SwellHeight > 0)
            {
                Add("swell_height", Waves.SwellHeight, "m");
                Add("swell_period", Waves.SwellPeriod, "s");
                Add("swell_direction", math.degrees(Math.Atan2(wind.x, wind.z)) + Waves.SwellDirectionDegrees
                    - Waves.WindDirectionDegrees, "deg");
            }
            Add("tile", Waves.TileSize, "m");
            Add("facet", Waves.TileSize / Waves.Cells, "m");
            Add("breaking_fraction", First.Clutter.BreakingFraction, "1");
            Add("water_temperature", _sea.Clutter.WaterTemperature, "C");
            Add("salinity", _sea.Clutter.Salinity, "psu");
            Add("cell_range", Cell.x, "m");
            Add("cell_across", Cell.y, "m");
            return info;
        }

        SeaSettings Waves => First.Clutter.LongWaves.Settings;

        void SwitchOn()
        {
            var settings = _sea.Clutter;
            if (_line.IsGiven(Options.Clutter))
                settings = _line.Get(Options.Clutter).AppliedTo(settings);
            if (!settings.IsOn)
                throw new GlintException($"{_line.Input}: the clutter of '{_sea.name}' is off: switch it on in its "
                    + $"inspector, or give {Options.Clutter.Flag} on");
            _sea.Clutter = settings;
        }

        // Snapshots or times; null for what the sea shows.
        IReadOnlyList<double?> MomentsOf()
        {
            if (_line.Get(ClutterOptions.Times) is double[] times)
                return _sea.Snapshots.Count == 0 ? Nullable(times)
                    : throw new GlintException($"{_line.Input}: '{_sea.name}' has snapshots, whose times are fixed: "
                        + $"give {Options.Snapshots.Flag} in place of {ClutterOptions.Times.Flag}");
            if (!(_line.Get(Options.Snapshots) is double[] snapshots))
                return new double?[] { null };
            foreach (double snapshot in snapshots)
                _sea.CheckSnapshot((int)snapshot);
            return Nullable(snapshots);
        }

        static IReadOnlyList<double?> Nullable(double[] values) => values.Select(value => (double?)value).ToArray();

        EndlessSea Show(double? moment)
        {
            if (moment is double number && _sea.Snapshots.Count > 0)
                _sea.Snapshot = (int)number;
            else if (moment is double time)
                _sea.TimeSeconds = time;
            var scene = _gatherer.Gather(~0, new[] { _sea.transform }, null);
            return scene.Seas.Count > 0 ? new EndlessSea(scene, scene.Seas[0])
                : throw new GlintException($"{_line.Input}: '{_sea.name}' has no tiles: enable it, and make its extent "
                    + "larger than 0");
        }

        double[] GrazingOf(SeaClutter clutter)
        {
            double[] all = _line.Get(ClutterOptions.Grazing);
            if (Model == null || _line.IsGiven(ClutterOptions.Grazing))
                return all;
            var held = all.Where(grazing => _frequencies.All(frequency => _azimuths.All(azimuth =>
                Model.Holds(clutter.ConditionsAt(frequency, azimuth, grazing))))).ToArray();
            return held.Length > 0 ? held : all;
        }

        void Validate(EndlessSea sea)
        {
            foreach (double frequency in _frequencies)
                sea.Clutter.TableAt(frequency);
            if (Model != null)
                foreach (double frequency in _frequencies)
                    foreach (double azimuth in _azimuths)
                        foreach (double grazing in _grazing)
                            Model.Require(sea.Clutter.ConditionsAt(frequency, azimuth, grazing));
            foreach (double azimuth in _azimuths)
            {
                int whole = sea.CellsOf(azimuth, Cell).AreWhole.Count(it => it);
                if (whole < MinCells)
                    Debug.LogWarning(FormattableString.Invariant(
                        $"{Name}: at azimuth {azimuth:g4} deg a tile of {Waves.TileSize:g5} m has {whole} cells of {Cell.x:g4} x {Cell.y:g4} m, and shapes take {MinCells}: their columns are empty; give the sea a larger tile, or a smaller {ClutterOptions.Cell.Flag}"));
            }
        }
    }
}
