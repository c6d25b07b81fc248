using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading.Tasks;

namespace Glint.Core
{
    /// <summary>
    /// The folder of the results of a run or sweep: the file of its table, such as results.csv, written row by row,
    /// and results.json at the end.
    /// An unfinished sweep also has results.partial, from which it can be resumed.
    /// Before the first row the folder holds only a lock file, and older results stay. One run at a time owns the
    /// folder, until it is disposed or finished.
    /// </summary>
    public sealed class ResultsFolder : IDisposable
    {
        /// <summary>File of the rows of a sweep or run.</summary>
        public const string CsvName = "results.csv";

        /// <summary>File of the rows and of everything about the run.</summary>
        public const string JsonName = "results.json";

        /// <summary>File of a sweep that is not finished.</summary>
        public const string PartialName = "results.partial";

        const string StartAnew =
            "use the same settings, choose another results folder, or leave --resume out to replace the results";

        static readonly UTF8Encoding Utf8 = new UTF8Encoding(false);

        // Letters.
        const int TextBuffer = 1 << 13;

        // Of an array.
        const int RowsAWrite = 1 << 12;

        readonly List<StoredRow> _rows = new List<StoredRow>();
        readonly MemoryStream _bytes = new MemoryStream();
        readonly ResultTable _table;
        readonly FolderLock _lock;
        SweepIdentity _sweep;
        FileStream _csv, _partial;
        long _csvLength, _partialLength;
        bool _finished;

        ResultsFolder(string path, ResultTable table)
        {
            (FolderPath, _table) = (path, table);
            _lock = new FolderLock(path);
        }

        /// <summary>The folder as given.</summary>
        public string FolderPath { get; }

        /// <summary>Path of the CSV file.</summary>
        public string CsvPath => Path.Combine(FolderPath, _table.CsvName);

        /// <summary>Path of the JSON file.</summary>
        public string JsonPath => Path.Combine(FolderPath, JsonName);

        /// <summary>Paths of its files that are there.</summary>
        public IReadOnlyList<string> WrittenPaths =>
            new[] { CsvPath, JsonPath }.Concat(WholePaths).Where(File.Exists).ToArray();

        /// <summary>Path of the file of an unfinished sweep.</summary>
        public string PartialPath => Path.Combine(FolderPath, PartialName);

        /// <summary>What the rows hold.</summary>
        public ResultTable Table => _table;

        /// <summary>The run that <see cref="Finish"/> described; null before.</summary>
        public RunInfo Info { get; private set; }

        /// <summary>First start of the sweep, UTC; null if unknown.</summary>
        public DateTime? StartedUtc { get; private set; }

        /// <summary>The rows so far, including those before a resumption.</summary>
        public IReadOnlyList<StoredRow> Rows => _rows;

        /// <summary>
        /// Checks, before any work is done, that no other run has the folder, and that both files can be written.
        /// Disposing it without a row leaves the folder unchanged.
        /// </summary>
        /// <param name="path">The folder.</param>
        /// <param name="table">What the rows hold; null: the poses of a sweep or run.</param>
        /// <exception cref="GlintException">
        /// Another run is writing there, it has rows of another table, or it cannot be written; the message names the
        /// folder or file.
        /// </exception>
        public static ResultsFolder Open(string path, ResultTable table = null)
        {
            if (string.IsNullOrEmpty(path))
                throw new GlintException("the results folder has an empty name; name a folder");
            var folder = new ResultsFolder(path, table ?? ResultTable.Sweep);
            try
            {
                folder.RefuseOtherTables();
                CheckReplaceable(folder.CsvPath);
                CheckReplaceable(folder.JsonPath);
                CheckReplaceable(folder.PartialPath);
                foreach (string whole in folder.WholePaths)
                    CheckReplaceable(whole);
                return folder;
            }
            catch
            {
                folder.Dispose();
                throw;
            }
        }

        /// <summary>Sets, before the first row, the identity of the sweep, so that it can be resumed.</summary>
        /// <exception cref="InvalidOperationException">The folder is finished.</exception>
        public void Begin(SweepIdentity sweep, DateTime startedUtc)
        {
            RequireUnfinished();
            _sweep = sweep;
            StartedUtc = startedUtc;
        }

        /// <summary>
        /// Resumes the same sweep, after <see cref="Begin(SweepIdentity, DateTime)"/>.
        /// Complete rows are kept, but at least the last pose is traced again.
        /// If there is nothing to resume, the sweep starts from its first pose.
        /// </summary>
        /// <param name="poses">Poses of the sweep, or of its part.</param>
        /// <param name="problemOf">
        /// What is wrong with a row, by its number from 0, such as "is of 15 deg instead of 10 deg"; null: nothing.
        /// </param>
        /// <returns>Number of poses done: all of them if results.json exists.</returns>
        /// <exception cref="GlintException">
        /// The folder holds results of another sweep, or damaged ones; the message says what differs. Nothing is
        /// changed.
        /// </exception>
        /// <exception cref="InvalidOperationException">The folder is finished.</exception>
        public int Resume(int poses, Func<int, StoredRow, string> problemOf = null)
        {
            RequireUnfinished();
            if (File.Exists(PartialPath))
                return GoOn(UnfinishedSweep.Read(PartialPath), poses, problemOf);
            if (File.Exists(JsonPath))
            {
                var done = StoredRun.ReadFile(JsonPath);
                Require(done.Info.Sweep, JsonPath);
                if (done.Rows.Count != poses)
                    throw new GlintException($"{JsonPath}: has {done.Rows.Count} rows of {poses}: it was changed; "
                        + "restore it, or leave --resume out");
                CheckRows(JsonPath, done.Rows, problemOf);
                _rows.AddRange(done.Rows);
                return poses;
            }
            if (File.Exists(CsvPath))
                throw new GlintException($"{CsvPath}: {PartialName} is not beside it, "
                    + "so that the sweep cannot be resumed: restore it, or leave --resume out");
            return 0;
        }

        /// <summary>
        /// Writes and flushes one row to the table's file, so that it survives the end of the program.
        /// The first row creates the folder, replaces an older file and removes an older results.json.
        /// </summary>
        /// <exception cref="GlintException">
        /// The disk is full or the file cannot be written; earlier rows stay. Or a value is not finite.
        /// </exception>
        /// <exception cref="InvalidOperationException">The folder is finished.</exception>
        public void Append(SweepRow row) => Append(new StoredRow(row));

        /// <summary>Writes and flushes some rows at once.</summary>
        /// <inheritdoc cref="Append(SweepRow)"/>
        public void Append(IReadOnlyList<CrossSectionRow> rows) => Append(StoredRow.Of(rows));

        /// <inheritdoc cref="Append(SweepRow)"/>
        public void Append(ClutterRow row) => Append(new StoredRow(row));

        internal void Append(params StoredRow[] rows)
        {
            RequireUnfinished();
            if (_csv == null)
                Create();
            Write(rows);
            _rows.AddRange(rows);
        }

        /// <summary>
        /// Writes results.json atomically, after the table's other files unless it is a part, and closes the rows'
        /// file.
        /// </summary>
        /// <param name="meanwhile">Done on this thread while others write files, after the images; may be null.</param>
        /// <exception cref="GlintException">A file cannot be written; that of the rows stays.</exception>
        /// <exception cref="InvalidOperationException">The folder is finished.</exception>
        public void Finish(RunInfo info, Action meanwhile = null)
        {
            RequireUnfinished();
            Info = info;
            if (_csv == null)
            {
                Create();
                Write(_rows);
            }
            try
            {
                Try($"{CsvPath}: cannot be written", CompleteRows);
                var run = new WholeRun(info, _rows);
                if (info.Sweep != null && info.Sweep.Shard == null)
                    WriteWholeFiles(run, meanwhile);
                Try($"{JsonPath}: cannot be written ({CsvPath} is complete)",
                    () => FileDraft.Write(JsonPath, file => WriteJson(file, info)));
                Try($"{PartialPath}: cannot be removed (the results are complete)", () => File.Delete(PartialPath));
            }
            finally
            {
                Dispose();
            }
        }

        /// <summary>Closes results.csv, whose rows stay, and releases the folder.</summary>
        public void Dispose()
        {
            if (_finished)
                return;
            Close();
            _lock.Dispose();
            _finished = true;
        }

        // Together, on other threads: those of rows while a device makes the images on this one.
        void WriteWholeFiles(WholeRun run, Action meanwhile)
        {
            var wanted = _table.WholeFiles.Where(whole => whole.IsWanted(run)).ToLookup(whole => whole.IsOfImage);
            var writing = new List<Task<GlintException>>();
            void Begin(bool isOfImage) =>
                writing.AddRange(wanted[isOfImage].Select(whole => Task.Run(() => WriteWhole(whole, run))));
            Begin(false);
            try
            {
                if (_table.HasProfiles)
                    run.Echo.MakeImages();
                Begin(true);
                meanwhile?.Invoke();
            }
            finally
            {
                Task.WaitAll(writing.ToArray());
            }
            if (writing.FirstOrDefault(file => file.Result != null) is Task<GlintException> failed)
                throw failed.Result;
        }

        // Returns what keeps it from being written.
        GlintException WriteWhole(WholeFile whole, WholeRun run)
        {
            try
            {
                Try($"{PathOf(whole)}: cannot be written ({CsvPath} is complete)",
                    () => FileDraft.Write(PathOf(whole), file => whole.Write(file, run)));
                return null;
            }
            catch (GlintException error)
            {
                return error;
            }
        }

        IEnumerable<string> WholePaths => _table.WholeFiles.Select(PathOf);

        string PathOf(WholeFile whole) => Path.Combine(FolderPath, whole.Name);

        void Close()
        {
            _csv?.Dispose();
            _partial?.Dispose();
            _csv = _partial = null;
        }

        void RequireUnfinished()
        {
            if (_finished)
                throw new InvalidOperationException($"{CsvPath} is finished");
        }

        void Create() => Try($"{CsvPath}: cannot be written", () =>
        {
            Directory.CreateDirectory(FolderPath);
            // First: a process that ends between these lines leaves a sweep without rows, which can be resumed.
            if (_sweep == null)
                File.Delete(PartialPath);
            else
            {
                // The rows of an array are in this file alone.
                if (_table.IsArray)
                    File.Delete(CsvPath);
                _partial = Open(PartialPath, FileMode.Create);
                _partialLength += Put(_partial,
                    text => text.Write(ResultsJson.Line(StartedUtc.Value, _sweep, _table) + "\n"));
            }
            File.Delete(JsonPath);
            foreach (string whole in WholePaths)
                File.Delete(whole);
            _csv = Open(CsvPath, FileMode.Create);
        }, KeepWholeRows);

        static void CheckRows(string path, IEnumerable<StoredRow> rows, Func<int, StoredRow, string> problemOf)
        {
            int number = 0;
            foreach (var row in rows)
                if (problemOf?.Invoke(number++, row) is string problem)
                    throw new GlintException($"{path}: row {number} {problem}: it was changed; "
                        + "restore it, or leave --resume out");
        }

        int GoOn(UnfinishedSweep earlier, int poses, Func<int, StoredRow, string> problemOf)
        {
            if (earlier == null)
                return 0;
            Require(earlier.Identity, PartialPath);
            // results.json describes the scene at the last pose, so that pose is traced again.
            int kept = Math.Min(earlier.Rows.Count, poses - 1);
            if (kept == 0)
                return 0;
            CheckRows(_table.IsArray ? CsvPath : PartialPath, earlier.Rows.Take(kept), problemOf);
            Try($"{CsvPath}: cannot be written", () =>
            {
                if (_table.IsArray)
                    KeepRows(earlier.Ends[0], RowArray.LengthOf(kept, _table), Array.Empty<byte>());
                else
                {
                    var csv = BytesOf(text => WriteCsv(text, _table.ColumnsOf(earlier.Rows.Take(1)),
                        earlier.Rows.Take(kept)));
                    int same = CheckCsv(earlier.Rows, csv);
                    KeepRows(earlier.Ends[kept], same, csv.Skip(same).ToArray());
                }
            }, Dispose);
            _rows.AddRange(earlier.Rows.Take(kept));
            StartedUtc = earlier.StartedUtc;
            return kept;
        }

        // Opens both files with the rows kept; more: what is missing at the end of that of the rows.
        void KeepRows(long partialLength, long csvLength, byte[] more)
        {
            _partial = Open(PartialPath, FileMode.Open);
            _partial.SetLength(_partialLength = partialLength);
            _partial.Seek(0, SeekOrigin.End);
            _csv = Open(CsvPath, FileMode.OpenOrCreate);
            _csv.SetLength(csvLength);
            _csv.Seek(0, SeekOrigin.End);
            _csv.Write(more, 0, more.Length);
            _csv.Flush();
            _csvLength = csvLength + more.Length;
        }

        // Refuses rows that were changed. Returns how many bytes stay: none where an older Glint wrote fewer columns,
        // or where all rows have the columns of a finished sweep.
        int CheckCsv(IReadOnlyList<StoredRow> rows, byte[] csv)
        {
            var there = File.Exists(CsvPath) ? File.ReadAllBytes(CsvPath) : Array.Empty<byte>();
            var names = Utf8.GetString(there.TakeWhile(letter => letter != '\n').ToArray()).Split(',');
            var begun = _table.ColumnsOf(rows.Take(1));
            var columns = _table.ColumnsOf(rows).Where(column => names.Contains(column.Name)).ToArray();
            bool isBegun = columns.Length != names.Length || columns.SequenceEqual(begun);
            var expected = BytesOf(text => WriteCsv(text, isBegun ? begun : columns, rows));
            int same = 0;
            while (same < there.Length && same < expected.Length && there[same] == expected[same])
                same++;
            if (same < there.Length)
                throw new GlintException($"{CsvPath}, line {1 + there.Take(same).Count(letter => letter == '\n')}: "
                    + $"differs from what {PartialName} holds: restore it, or delete it to have it written again");
            return isBegun ? Math.Min(same, csv.Length) : 0;
        }

        static void WriteCsv(TextWriter text, IReadOnlyList<ResultColumn> columns, IEnumerable<StoredRow> rows,
            bool hasHeader = true)
        {
            if (hasHeader)
                text.Write(string.Join(",", columns.Select(column => column.Name)) + "\n");
            foreach (var row in rows)
                row.WriteCsv(text, columns);
        }

        void Require(SweepIdentity earlier, string path)
        {
            if (earlier == null)
                throw new GlintException($"{path}: is of a single pose, not a sweep: {StartAnew}");
            string difference = _sweep.DifferenceFrom(earlier);
            if (difference != null)
                throw new GlintException($"{path}: is of another sweep: {difference}: {StartAnew}");
        }

        // Rows before the first one with optional columns, such as an echo that is not 0, were written without them.
        void CompleteRows()
        {
            if (_table.IsArray)
                WriteArrayHeader();
            Close();
            var columns = _table.ColumnsOf(_rows);
            if (columns.Count != _table.ColumnsOf(_rows.Take(1)).Count)
                FileDraft.Write(CsvPath, file => WriteTo(file, text => WriteCsv(text, columns, _rows)));
        }

        void WriteArrayHeader()
        {
            var header = RowArray.Header(_rows.Count, _table);
            _csv.Seek(0, SeekOrigin.Begin);
            _csv.Write(header, 0, header.Length);
        }

        // results.partial first: a sweep is resumed from it. An incomplete row in either file is cut off.
        void Write(IReadOnlyList<StoredRow> rows)
        {
            try
            {
                int more = _sweep == null || _table.IsArray ? 0 : Put(_partial, text => WriteLines(text, rows));
                _csvLength += _table.IsArray ? PutArray(rows) : Put(_csv, text => WriteCsv(text, rows));
                _partialLength += more;
            }
            // ArgumentException: a file that cannot grow further
            catch (Exception error) when (error is IOException || error is ArgumentException)
            {
                KeepWholeRows();
                throw Failure($"{CsvPath}: cannot be written ({_rows.Count} rows are in it)", error);
            }
        }

        void WriteLines(TextWriter text, IReadOnlyList<StoredRow> rows)
        {
            foreach (var row in rows)
            {
                ResultsJson.WriteRow(text, row, _table);
                text.Write('\n');
            }
        }

        // The columns are those of the first row until the end (CompleteRows).
        void WriteCsv(TextWriter text, IReadOnlyList<StoredRow> rows)
        {
            bool isFirst = _csvLength == 0;
            WriteCsv(text, _table.ColumnsOf((_rows.Count == 0 ? rows : _rows).Take(1)), rows, isFirst);
        }

        int PutArray(IReadOnlyList<StoredRow> rows)
        {
            int written = 0;
            for (int first = 0; first < rows.Count || first == 0; first += RowsAWrite)
            {
                _bytes.SetLength(0);
                if (_csvLength + written == 0)
                    _bytes.Write(RowArray.Header(0, _table), 0, (int)RowArray.LengthOf(0, _table));
                RowArray.Write(_bytes, rows, first, Math.Min(RowsAWrite, rows.Count - first), _table);
                written += PutBytes(_csv);
            }
            return written;
        }

        int Put(FileStream file, Action<TextWriter> write)
        {
            _bytes.SetLength(0);
            WriteTo(_bytes, write);
            return PutBytes(file);
        }

        // At once: the file has no buffer.
        int PutBytes(FileStream file)
        {
            file.Write(_bytes.GetBuffer(), 0, (int)_bytes.Length);
            file.Flush();
            return (int)_bytes.Length;
        }

        static byte[] BytesOf(Action<TextWriter> write)
        {
            var bytes = new MemoryStream();
            WriteTo(bytes, write);
            return bytes.ToArray();
        }

        static void WriteTo(Stream output, Action<TextWriter> write)
        {
            using (var text = new StreamWriter(output, Utf8, TextBuffer, leaveOpen: true))
                write(text);
        }

        // Unbuffered, so that closing does not write a failed row again.
        static FileStream Open(string path, FileMode mode) =>
            new FileStream(path, mode, FileAccess.Write, FileShare.Read, 1);

        // Removes an incomplete row, and a file without rows. If this fails too, the first failure is reported.
        void KeepWholeRows()
        {
            try
            {
                if (_csvLength > 0)
                    _csv.SetLength(_csvLength);
                if (_partialLength > 0)
                    _partial.SetLength(_partialLength);
                bool hasCsv = _csv != null, hasPartial = _partial != null;
                Close();
                if (_rows.Count == 0 && hasCsv)
                    File.Delete(CsvPath);
                if (_rows.Count == 0 && hasPartial)
                    File.Delete(PartialPath);
            }
            catch (Exception error) when (error is IOException || error is UnauthorizedAccessException)
            {
            }
            finally
            {
                Dispose();
            }
        }

        void WriteJson(Stream file, RunInfo info)
        {
            using (var text = new StreamWriter(file, Utf8, 1 << 16) { NewLine = "\n" })
                ResultsJson.Write(text, info, _rows, _table);
        }

        void RefuseOtherTables()
        {
            var other = ResultTable.All.FirstOrDefault(
                table => table != _table && File.Exists(Path.Combine(FolderPath, table.CsvName)));
            if (other != null)
                throw new GlintException($"{FolderPath}: holds {other.CsvName}, the results of glint {other.Name}: "
                    + "choose another results folder");
        }

        static void CheckReplaceable(string path)
        {
            if (Directory.Exists(path))
                throw new GlintException($"{path}: is a folder, but a file of that name has to be written; "
                    + "remove it or choose another results folder");
            if (File.Exists(path))
                Try($"{path}: cannot be replaced (is it open in another program?)",
                    () => new FileStream(path, FileMode.Open, FileAccess.Write, FileShare.Read).Dispose());
        }

        static void Try(string failure, Action work, Action afterFailure = null)
        {
            try
            {
                work();
            }
            catch (Exception error) when (error is IOException || error is UnauthorizedAccessException
                || error is ArgumentException || error is NotSupportedException)
            {
                afterFailure?.Invoke();
                throw Failure(failure, error);
            }
        }

        static GlintException Failure(string failure, Exception error) =>
            new GlintException($"{failure}: {error.Message.TrimEnd('.')}; free the disk or the file, "
                + "or choose another results folder", error);
    }
}
