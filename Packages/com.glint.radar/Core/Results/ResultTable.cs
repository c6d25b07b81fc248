using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Glint.Core
{
    /// <summary>What a command writes into a results folder: its columns, and the names of its files.</summary>
    public sealed class ResultTable
    {
        /// <summary>The poses of a sweep or run.</summary>
        public static readonly ResultTable Sweep =
            new ResultTable("sweep", ResultsFolder.CsvName, ResultColumn.All) { HasTimings = true };

        /// <summary>Cross sections.</summary>
        public static readonly ResultTable CrossSection = new ResultTable("rcs", "rcs.csv", CrossSectionColumn.All)
        {
            FolderSuffix = "-rcs",
            WholeFiles = new[]
            {
                new WholeFile("rcs.npz", CrossSectionArrays.Write, run => true),
                new WholeFile("contributions.csv", ContributionFiles.WriteContributions,
                    run => ContributionFiles.AreIn(run.Rows)),
                new WholeFile("hotspots.csv", ContributionFiles.WriteHotSpots,
                    run => ContributionFiles.AreIn(run.Rows))
            }
        };

        static readonly WholeFile[] s_profiles = new[]
            {
                new WholeFile("profile.csv", EchoFiles.WriteTable, run => run.Echo.Settings.Image == null),
                new WholeFile("doppler.csv", EchoFiles.WriteMaps,
                    run => run.Echo.Plan.Pulses != null),
                new WholeFile("detections.csv", EchoFiles.WriteDetections,
                    run => run.Echo.Settings.Detection != null),
                new WholeFile("echo.npz", EchoFiles.WriteNumpy, run => true),
                new WholeFile("echo.mat", EchoFiles.WriteMatlab, run => run.Echo.Settings.HasMatlab),
                new WholeFile("echo.sigmf-data", EchoFiles.WriteSigMfData,
                    run => run.Echo.Settings.HasSigMf),
                new WholeFile("echo.sigmf-meta", EchoFiles.WriteSigMfMeta,
                    run => run.Echo.Settings.HasSigMf)
            }.Concat(ImageFiles.All).ToArray();

        /// <summary>Responses over a band, and the range profiles made of them.</summary>
        public static readonly ResultTable Echo = new ResultTable("echo", "responses.csv", CrossSectionColumn.OfEchoes)
        {
            FolderSuffix = "-echo", HasProfiles = true, WholeFiles = s_profiles
        };

        /// <summary>Responses over a band in the directions of an image, and the image.</summary>
        public static readonly ResultTable Image = new ResultTable("isar", "responses.npy", CrossSectionColumn.OfEchoes)
        {
            FolderSuffix = "-isar", HasProfiles = true, WholeFiles = s_profiles, IsArray = true
        };

        /// <summary>Mean echo and texture of a sea.</summary>
        public static readonly ResultTable Clutter = new ResultTable("clutter", "clutter.csv", ClutterColumn.All)
        {
            FolderSuffix = "-clutter"
        };

        /// <summary>The turn of a radar screen, by whose video the folder is known. It has no rows.</summary>
        public static readonly ResultTable Screen = new ResultTable("ppi", "video.npz", Array.Empty<ResultColumn>())
        {
            FolderSuffix = "-ppi"
        };

        /// <summary>Every table.</summary>
        public static readonly IReadOnlyList<ResultTable> All = new[]
            { Sweep, CrossSection, Echo, Image, Clutter, Screen };

        readonly ResultColumn[] _optional, _required;

        ResultTable(string name, string csvName, IReadOnlyList<ResultColumn> columns)
        {
            (Name, CsvName, Columns) = (name, csvName, columns);
            _optional = columns.Where(column => column.IsOptional).ToArray();
            _required = columns.Where(column => !column.IsOptional).ToArray();
        }

        /// <summary>Name of the command that writes it.</summary>
        public string Name { get; }

        /// <summary>File of the rows.</summary>
        public string CsvName { get; }

        /// <summary>Ends the name of the default folder; null for nothing.</summary>
        public string FolderSuffix { get; private set; }

        /// <summary>The columns, in the order of the files.</summary>
        public IReadOnlyList<ResultColumn> Columns { get; }

        /// <summary>The columns of the files of rows: optional ones if a row has a value of any.</summary>
        internal IReadOnlyList<ResultColumn> ColumnsOf(IEnumerable<StoredRow> rows) =>
            IsArray || rows.Any(row => ColumnsOf(row) == Columns) ? Columns : _required;

        /// <summary>The columns of a row: optional ones if it has a value of any.</summary>
        internal IReadOnlyList<ResultColumn> ColumnsOf(StoredRow row) =>
            Array.Exists(_optional, column => row[column] != null) ? Columns : _required;

        /// <summary>
        /// Whether the rows, which may be very many, are an array (<see cref="RowArray"/>) instead of lines of text, and
        /// are not in results.json.
        /// </summary>
        internal bool IsArray { get; private set; }

        /// <summary>Whether range profiles are made of the rows (<see cref="EchoProfiles"/>).</summary>
        public bool HasProfiles { get; private set; }

        /// <summary>Whether each row has timings.</summary>
        public bool HasTimings { get; private set; }

        /// <summary>
        /// Other files made of all rows. A part of a sweep does not have them, its merged whole does.
        /// </summary>
        internal IReadOnlyList<WholeFile> WholeFiles { get; private set; } = Array.Empty<WholeFile>();

        /// <summary>The table of a name in results.json; null: that of sweeps.</summary>
        /// <exception cref="FormatException">There is no such table.</exception>
        internal static ResultTable Find(string name) => name == null ? Sweep
            : All.FirstOrDefault(table => table.Name == name)
                ?? throw new FormatException($"its table is {Values.Shown(name)}");
    }

    /// <summary>A file made of the rows of a whole sweep.</summary>
    sealed class WholeFile
    {
        public WholeFile(string name, Action<Stream, WholeRun> write, Func<WholeRun, bool> isWanted) =>
            (Name, Write, IsWanted) = (name, write, isWanted);

        public string Name { get; }

        public Action<Stream, WholeRun> Write { get; }

        /// <summary>Whether it is written for these rows.</summary>
        public Func<WholeRun, bool> IsWanted { get; }

        /// <summary>Whether it is made of <see cref="EchoProfiles.Image"/>.</summary>
        public bool IsOfImage { get; set; }
    }

    /// <summary>A whole run, for the files made of it.</summary>
    sealed class WholeRun
    {
        readonly Lazy<EchoProfiles> _echo;

        public WholeRun(RunInfo info, IReadOnlyList<StoredRow> rows)
        {
            (Info, Rows) = (info, rows);
            _echo = new Lazy<EchoProfiles>(() => new EchoProfiles(info, rows));
        }

        public RunInfo Info { get; }

        public IReadOnlyList<StoredRow> Rows { get; }

        /// <summary>Of a run with <see cref="ResultTable.HasProfiles"/>.</summary>
        public EchoProfiles Echo => _echo.Value;
    }
}
