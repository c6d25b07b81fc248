using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;
using Debug = UnityEngine.Debug;

namespace Glint.Editor
{
    /// <summary><c>glint ppi</c>: turns of the radar screen of a scene, frame by frame.</summary>
    static class ScreenCommand
    {
        // Time of a stream in that of the scene.
        const double MaxDelay = 1.1;

        public static int Execute(CommandLine line, IProgressSink progress)
        {
            string folder = line.IsGiven(ScreenOptions.Out) ? Path.GetFullPath(line.Get(ScreenOptions.Out))
                : RunDescription.DefaultFolder(Path.GetFileNameWithoutExtension(line.Input), ResultTable.Screen);
            VideoOutput.Check(line, folder);
            LoadedScene.OpenSceneFile(line.Input);
            var screen = SceneSearch.FindOnly<RadarScreen>(line.Input, "radar screen",
                "RadarScreen (Glint > Radar Screen) to an object of the scene");
            // A scene may be stored without them.
            if (screen.Kernel == null)
                screen.Kernel = ProjectAssets.ScreenKernel;
            if (screen.SeaKernel == null)
                screen.SeaKernel = ProjectAssets.SeaKernel;
            if (line.Get(ScreenOptions.Detect) is string level)
                screen.Detection = new ScreenDetection
                {
                    Level = EchoDetection.LevelOf(level), FalseAlarmRate = line.Get(ScreenOptions.FalseAlarm)
                };
            // The first frame refuses what is wrong, before files are made.
            try
            {
                return Play(line, screen, folder, progress);
            }
            finally
            {
                screen.enabled = false;
            }
        }

        static int Play(CommandLine line, RadarScreen screen, string folder, IProgressSink progress)
        {
            RequireFrames(line.Get(ScreenOptions.FrameRate), screen);
            var play = new ScenePlay(screen);
            play.Advance(line.Get(ScreenOptions.Time), 0);
            using (ResultsFolder.Open(folder, ResultTable.Screen))
            using (var output = new VideoOutput(line, screen.Geometry))
            {
                var files = new ScreenFiles(line, screen, folder);
                int code = Turn(line, play, output, progress);
                if (code != Batch.Done)
                    return code;
                output.Finish();
                progress.Print($"written: {string.Join(", ", files.Write().Concat(output.Paths))}");
            }
            return Batch.Done;
        }

        // A frame finishes half a turn at most.
        static void RequireFrames(int rate, RadarScreen screen)
        {
            double atLeast = screen.Radar.TurnsAMinute / 30;
            if (rate < atLeast)
                throw new GlintException(FormattableString.Invariant(
                    $"'{screen.name}' turns {screen.Radar.TurnsAMinute:g4} times a minute, and a frame shows half a turn at most: give at least {Math.Ceiling(atLeast)} for {ScreenOptions.FrameRate.Flag}"));
        }

        static int Turn(CommandLine line, ScenePlay play, VideoOutput output, IProgressSink progress)
        {
            var screen = play.Screen;
            int turns = line.Get(ScreenOptions.Turns), rate = line.Get(ScreenOptions.FrameRate),
                // The last spoke of the last turn is finished one frame later at most.
                frames = (int)Math.Ceiling(turns * 60 / screen.Radar.TurnsAMinute * rate) + 1;
            progress.Print(FormattableString.Invariant(
                $"{screen.Radar.Spokes} spokes of {screen.Radar.Cells} cells of {screen.Geometry.CellSize:g4} m, noise {PowerLevel.ToDecibels(screen.Geometry.NoisePower):0.0} dBW"));
            progress.Print(FormattableString.Invariant(
                $"{screen.PointCount} points on meshes, {screen.PointSpacing:0.00} m apart on large ones, {screen.MeshBytes / 1e6:0.0} MB with their BVHs"));
            progress.Start(line.Input, frames);
            var watch = Stopwatch.StartNew();
            try
            {
                for (int frame = 0; frame < frames; frame++)
                {
                    if (progress.Cancel.IsCancellationRequested)
                        return Batch.Cancelled;
                    play.Advance(1.0 / rate, 1.0 / rate);
                    output.Add(screen);
                    if (line.IsGiven(ScreenOptions.Udp))
                        Wait((frame + 1.0) / rate - watch.Elapsed.TotalSeconds);
                    progress.Advance(frame + 1, FormattableString.Invariant($"{screen.AntennaDegrees:0} deg"));
                }
            }
            finally
            {
                progress.Finish();
            }
            progress.Print(FormattableString.Invariant(
                $"{turns} {(turns == 1 ? "turn" : "turns")} in {watch.Elapsed.TotalSeconds:0.0} s, {frames} frames; main thread {play.MedianMilliseconds:0.000} ms a frame for the radar (median)"));
            if (line.IsGiven(ScreenOptions.Udp)
                && WarningOfDelay(line.Input, watch.Elapsed.TotalSeconds, (double)frames / rate) is string warning)
                Debug.LogWarning(warning);
            return Batch.Done;
        }

        /// <summary>The warning of a stream that was not in real time; null if it was.</summary>
        /// <param name="seconds">Time that it took: a frame that is late is made up for by the next ones.</param>
        /// <param name="expected">Time that it has in the scene.</param>
        internal static string WarningOfDelay(string name, double seconds, double expected) =>
            seconds <= MaxDelay * expected ? null : FormattableString.Invariant(
                $"{name}: the stream was not in real time: it took {seconds:0.00} s instead of {expected:0.00} s; use a faster device, fewer spokes or cells, or fewer frames a second ({ScreenOptions.FrameRate.Flag})");

        static void Wait(double seconds)
        {
            if (seconds > 0)
                Thread.Sleep(TimeSpan.FromSeconds(seconds));
        }
    }

    /// <summary>A scene that runs without an engine's loop: seas, ships and the radar.</summary>
    sealed class ScenePlay
    {
        readonly Underway[] _ships = SceneSearch.FindEnabled<Underway>();
        readonly Sea[] _seas = SceneSearch.FindEnabled<Sea>();

        readonly List<double> _milliseconds = new List<double>();

        public ScenePlay(RadarScreen screen) => Screen = screen;

        public RadarScreen Screen { get; }

        /// <summary>Time of the main thread for the radar's part of a frame.</summary>
        public double MedianMilliseconds => _milliseconds.OrderBy(time => time).ElementAt(_milliseconds.Count / 2);

        /// <summary>Moves the scene, and the radar, for some seconds.</summary>
        public void Advance(double seconds, double ofRadar)
        {
            foreach (var ship in _ships)
                ship.Advance(seconds);
            foreach (var sea in _seas)
                if (sea.Motion == SeaMotion.Waves)
                    sea.TimeSeconds += seconds;
            var watch = Stopwatch.StartNew();
            Screen.Advance(ofRadar);
            _milliseconds.Add(watch.Elapsed.TotalMilliseconds);
        }
    }

    /// <summary>Radar video of each frame, to a file and by UDP.</summary>
    sealed class VideoOutput : IDisposable
    {
        static readonly string AnotherFile = $"name another file with {ScreenOptions.Asterix.Flag}";

        readonly ScreenAsterix _encoder;
        readonly DatagramSender _sender;
        readonly double _start = DateTime.UtcNow.TimeOfDay.TotalSeconds;

        FileDraft _file;
        double _seconds;

        public VideoOutput(CommandLine line, ScreenGeometry geometry)
        {
            var udp = line.Get(ScreenOptions.Udp);
            string path = line.Get(ScreenOptions.Asterix);
            if (udp == null && path == null)
                return;
            _encoder = new ScreenAsterix(geometry);
            if (udp != null)
                _sender = new DatagramSender(udp.Port, udp.Host, line.Get(ScreenOptions.Ttl));
            if (path == null)
                return;
            Paths = new[] { Path.GetFullPath(path) };
            try
            {
                Try(Paths[0], () =>
                {
                    Directory.CreateDirectory(Path.GetDirectoryName(Paths[0]));
                    _file = new FileDraft(Paths[0]);
                });
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        public string[] Paths { get; private set; } = new string[0];

        /// <summary>Refuses a place where no recording can be, before any work.</summary>
        /// <param name="folder">The results folder.</param>
        /// <exception cref="GlintException">
        /// The path is a folder or one of the results, or a file that is no recording is there.
        /// </exception>
        public static void Check(CommandLine line, string folder)
        {
            string path = line.Get(ScreenOptions.Asterix);
            if (path == null)
                return;
            if (ScreenFiles.Names.Any(name => Path.GetFullPath(path) == Path.Combine(folder, name)))
                throw new UsageException($"{ScreenOptions.Asterix.Flag} {path}: is a file of the results: name another one");
            if (Directory.Exists(path))
                throw new GlintException(
                    $"{path}: is a folder: name a file in it with {ScreenOptions.Asterix.Flag}");
            Try(path, () =>
            {
                if (!FileDraft.MayReplace(path, file => file.ReadByte() == AsterixVideo.Category))
                    throw new GlintException($"{path}: is there, and is no radar video that could be replaced: "
                        + AnotherFile);
            });
        }

        /// <summary>Writes the spokes of the last frame.</summary>
        public void Add(RadarScreen screen)
        {
            if (_encoder == null)
                return;
            var geometry = screen.Geometry;
            float2[] video = screen.ReadFrame(out long first);
            for (int i = 0; i < video.Length / geometry.Radar.Cells; i++)
            {
                _seconds += 60 / geometry.Radar.TurnsAMinute / geometry.Radar.Spokes;
                byte[] message = _encoder.Encode(first + i, video, i * geometry.Radar.Cells,
                    (_start + _seconds) % 86400);
                if (_file != null)
                    Try(Paths[0], () => _file.Stream.Write(message, 0, message.Length));
                _sender?.Send(message);
            }
        }

        /// <summary>The recording is complete: moves it to its place.</summary>
        public void Finish()
        {
            if (_file != null)
                Try(Paths[0], _file.Finish);
        }

        static void Try(string path, Action work)
        {
            try
            {
                work();
            }
            catch (Exception error) when (error is IOException || error is UnauthorizedAccessException)
            {
                throw ScreenFiles.Refusal(path, error, AnotherFile);
            }
        }

        public void Dispose()
        {
            _sender?.Dispose();
            if (_file != null)
                Try(Paths[0], _file.Dispose);
        }
    }
}
