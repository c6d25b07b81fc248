using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Glint.Core;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Editor
{
    /// <summary>Files of the turn that a radar screen shows: picture, video, detections and results.json.</summary>
    sealed class ScreenFiles
    {
        const string PictureName = "picture.png", TableName = "video.csv", DetectionsName = "detections.csv";

        /// <summary>Every file that it may write.</summary>
        public static readonly string[] Names =
        {
            ResultsFolder.JsonName, PictureName, ResultTable.Screen.CsvName, TableName, DetectionsName
        };

        readonly CommandLine _line;
        readonly RadarScreen _screen;
        readonly string _folder;
        readonly DateTime _startedUtc = DateTime.UtcNow;
        readonly List<string> _paths = new List<string>();

        /// <param name="folder">It is there.</param>
        public ScreenFiles(CommandLine line, RadarScreen screen, string folder) =>
            (_line, _screen, _folder) = (line, screen, folder);

        /// <summary>Writes the files.</summary>
        /// <returns>Their paths.</returns>
        public IReadOnlyList<string> Write()
        {
            // Of a run before.
            foreach (string name in Names)
                At(name, File.Delete);
            var detected = _line.IsGiven(ScreenOptions.Detect) ? _screen.ReadDetections() : null;
            Write(PictureName, file => WritePicture(file, detected));
            var turn = ScreenTurn.Of(_screen.Geometry, _screen.ReadLevels(), _screen.ReadVideo().Select(video => video.x),
                detected, _screen.HeadingDegrees);
            Write(ResultTable.Screen.CsvName, turn.Write);
            if (_line.Get(ScreenOptions.Table))
                Write(TableName, turn.WriteTable);
            if (detected != null)
                Write(DetectionsName, turn.WriteDetections);
            Write(ResultsFolder.JsonName, WriteDescription);
            return _paths;
        }

        void Write(string name, Action<Stream> write)
        {
            At(name, path => FileDraft.Write(path, write));
            _paths.Add(Path.Combine(_folder, name));
        }

        void At(string name, Action<string> change)
        {
            string path = Path.Combine(_folder, name);
            try
            {
                change(path);
            }
            catch (Exception error) when (error is IOException || error is UnauthorizedAccessException)
            {
                throw Refusal(path, error, "choose another results folder");
            }
        }

        /// <summary>The refusal of a path that takes no file.</summary>
        public static GlintException Refusal(string path, Exception error, string wayOut) =>
            new GlintException($"{path}: cannot be written: {error.Message.TrimEnd('.')}; {wayOut}", error);

        void WriteDescription(Stream file)
        {
            using (var text = new StreamWriter(file, new UTF8Encoding(false)))
                ResultsJson.Write(text, Describe(), Array.Empty<StoredRow>(), ResultTable.Screen);
        }

        void WritePicture(Stream file, IEnumerable<ScreenDetected> detected)
        {
            int side = _screen.Display.Side;
            byte[] pixels = Pixels(), fromTop = new byte[pixels.Length];
            if (detected != null)
                _screen.Mark(pixels, detected);
            for (int row = 0; row < side; row++)
                Array.Copy(pixels, 4 * side * row, fromTop, 4 * side * (side - 1 - row), 4 * side);
            PngFile.WriteColour(file, side, fromTop);
        }

        byte[] Pixels()
        {
            // The texture of a project with linear colours is not encoded as PNG files are.
            if (_screen.Picture == null || QualitySettings.activeColorSpace == ColorSpace.Linear
                || !SystemInfo.supportsAsyncGPUReadback)
                return _screen.ReadPicture();
            var request = AsyncGPUReadback.Request(_screen.Picture);
            request.WaitForCompletion();
            if (request.hasError)
                throw new GlintException($"the picture of '{_screen.name}' could not be read back from the device");
            return request.GetData<byte>().ToArray();
        }

        RunInfo Describe()
        {
            var info = RunDescription.OfMachine();
            (info.Objects, info.Triangles) = (_screen.ObjectCount, _screen.TriangleCount);
            (info.ScenePath, info.Command) = (_line.Input, Batch.ArgumentsOf(_line));
            (info.StartedUtc, info.ElapsedMs) = (_startedUtc, (DateTime.UtcNow - _startedUtc).TotalMilliseconds);
            info.Settings.Add(new RunSetting("turns", _line.Get(ScreenOptions.Turns), "1"));
            info.Settings.Add(new RunSetting("frames_a_second", _line.Get(ScreenOptions.FrameRate), "1"));
            info.Settings.Add(new RunSetting("time_before", _line.Get(ScreenOptions.Time), "s"));
            Add(info, ScreenRadar.Measures, _screen.Radar);
            info.Settings.Add(new RunSetting("pattern", _screen.Radar.Pattern.ToString().ToLowerInvariant()));
            info.Settings.Add(new RunSetting("interfering_radars", SceneSearch.FindEnabled<InterferingRadar>().Length, "1"));
            info.Settings.Add(new RunSetting("polarisation", _screen.Radar.Polarisation.ToString().ToLowerInvariant()));
            Add(info, ScreenReceiver.Measures, _screen.Receiver);
            info.Settings.Add(new RunSetting("trail_motion",
                _screen.Receiver.TrailMotion.ToString().ToLowerInvariant()));
            if (_screen.Sea != null)
                info.Settings.Add(new RunSetting("clutter", _screen.Sea.CurrentClutter().ToString()));
            if (!_line.IsGiven(ScreenOptions.Detect))
                return info;
            info.Settings.Add(new RunSetting("detection", _line.Get(ScreenOptions.Detect)));
            Add(info, ScreenDetection.Measures, _screen.Detection);
            return info;
        }

        static void Add(RunInfo info, IEnumerable<Measure> measures, object settings)
        {
            foreach (var measure in measures)
                info.Settings.Add(new RunSetting(measure.Title.ToLowerInvariant().Replace(' ', '_'),
                    measure.Of(settings), measure.Unit.Length == 0 ? "1" : measure.Unit));
        }
    }
}
