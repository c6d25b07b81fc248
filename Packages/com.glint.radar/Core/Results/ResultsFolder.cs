using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;

namespace Glint.Core
{
    /// <summary>
    /// The folder that a run or sweep writes: results.csv, row by row as they are done, and results.json at the end.
    /// Before the first row only a lock file is there, and older results stay. One run at a time has the folder, until it is disposed or finished.
    /// </summary>
    public sealed class ResultsFolder : IDisposable
    {
        /// <summary>File of the rows.</summary>
        public const string CsvName = "results.csv";

        /// <summary>File of the rows and of everything about the run.</summary>
        public const string JsonName = "results.json";

        static readonly UTF8Encoding Utf8 = new UTF8Encoding(false);

        readonly List<StoredRow> _rows = new List<StoredRow>();
        readonly FolderLock _lock;
        FileStream _csv;
        long _csvLength;
        bool _finished;

        ResultsFolder(string path)
        {
            FolderPath = path;
            _lock = new FolderLock(path);
        }

        /// <summary>The folder as it was given.</summary>
        public string FolderPath { get; }

        /// <summary>Path of the CSV file.</summary>
        public string CsvPath => Path.Combine(FolderPath, CsvName);

        /// <summary>Path of the JSON file.</summary>
        public string JsonPath => Path.Combine(FolderPath, JsonName);

        static string Header => string.Join(",", ResultColumn.All.Select(column => column.Name)) + "\n";

        string TemporaryJsonPath => JsonPath + ".tmp";

        /// <summary>
        /// Makes sure, before any work is done, that no other run has the folder, and that both files can be written.
        /// Disposing it without a row leaves everything as it was.
        /// </summary>
        /// <exception cref="GlintException">Another run is writing there, or it cannot be written; the message names the folder or file.</exception>
        public static ResultsFolder Open(string path)
        {
            if (string.IsNullOrEmpty(path))
                throw new GlintException("the results folder has an empty name; name a folder");
            var folder = new ResultsFolder(path);
            try
            {
                CheckReplaceable(folder.CsvPath);
                CheckReplaceable(folder.JsonPath);
                return folder;
            }
            catch
            {
                folder.Dispose();
                throw;
            }
        }

        /// <summary>
        /// Writes one row to results.csv, so that it is there even if the program is ended at once.
        /// The first row makes the folder, replaces an older results.csv and removes an older results.json.
        /// </summary>
        /// <exception cref="GlintException">The disk is full or the file cannot be written; earlier rows stay. Or a value is not finite.</exception>
        /// <exception cref="InvalidOperationException">The folder is finished.</exception>
        public void Append(SweepRow row)
        {
            RequireUnfinished();
            var stored = new StoredRow(row);
            if (_csv == null)
                Begin();
            Write((_rows.Count == 0 ? Header : "") + stored.ToCsv());
            _rows.Add(stored);
        }

        /// <summary>Writes results.json, whole or not at all, and closes results.csv.</summary>
        /// <exception cref="GlintException">The file cannot be written; results.csv stays.</exception>
        /// <exception cref="InvalidOperationException">The folder is finished.</exception>
        public void Finish(RunInfo info)
        {
            RequireUnfinished();
            if (_csv == null)
            {
                Begin();
                Write(Header);
            }
            CloseCsv();
            try
            {
                var text = new StringWriter { NewLine = "\n" };
                ResultsJson.Write(text, info, _rows);
                Try($"{JsonPath}: cannot be written ({CsvPath} is complete)", () => ReplaceJson(Utf8.GetBytes(text.ToString())));
            }
            finally
            {
                Dispose();
            }
        }

        /// <summary>Closes results.csv, whose rows stay, and lets the folder go.</summary>
        public void Dispose()
        {
            if (_finished)
                return;
            CloseCsv();
            _lock.Dispose();
            _finished = true;
        }

        void CloseCsv()
        {
            _csv?.Dispose();
            _csv = null;
        }

        void RequireUnfinished()
        {
            if (_finished)
                throw new InvalidOperationException($"{CsvPath} is finished");
        }

        void Begin() => Try($"{CsvPath}: cannot be written", () =>
        {
            Directory.CreateDirectory(FolderPath);
            File.Delete(JsonPath);
            // Without a buffer a row that failed is not written again on closing.
            _csv = new FileStream(CsvPath, FileMode.Create, FileAccess.Write, FileShare.Read, 1);
        });

        void Write(string lines)
        {
            var bytes = Utf8.GetBytes(lines);
            try
            {
                _csv.Write(bytes, 0, bytes.Length);
                _csv.Flush();
                _csvLength += bytes.Length;
            }
            catch (IOException error)
            {
                KeepWholeRows();
                throw Failure($"{CsvPath}: cannot be written ({_rows.Count} rows are in it)", error);
            }
        }

        // Half a row must not stay, nor a file without rows. If even this fails, the first failure is the one to tell.
        void KeepWholeRows()
        {
            try
            {
                if (_csvLength > 0)
                    _csv.SetLength(_csvLength);
                CloseCsv();
                if (_csvLength == 0)
                    File.Delete(CsvPath);
            }
            catch (IOException)
            {
            }
            finally
            {
                Dispose();
            }
        }

        void ReplaceJson(byte[] bytes)
        {
            try
            {
                File.WriteAllBytes(TemporaryJsonPath, bytes);
                if (File.Exists(JsonPath))
                    File.Replace(TemporaryJsonPath, JsonPath, null);
                else
                    File.Move(TemporaryJsonPath, JsonPath);
            }
            finally
            {
                File.Delete(TemporaryJsonPath);
            }
        }

        static void CheckReplaceable(string path)
        {
            if (Directory.Exists(path))
                throw new GlintException($"{path}: is a folder, but a file of that name has to be written; remove it or choose another results folder");
            if (File.Exists(path))
                Try($"{path}: cannot be replaced (is it open in another program?)", () => new FileStream(path, FileMode.Open, FileAccess.Write, FileShare.Read).Dispose());
        }

        static void Try(string failure, Action work)
        {
            try
            {
                work();
            }
            catch (Exception error) when (error is IOException || error is UnauthorizedAccessException || error is ArgumentException || error is NotSupportedException)
            {
                throw Failure(failure, error);
            }
        }

        static GlintException Failure(string failure, Exception error) =>
            new GlintException($"{failure}: {error.Message.TrimEnd('.')}; free the disk or the file, or choose another results folder", error);
    }
}
