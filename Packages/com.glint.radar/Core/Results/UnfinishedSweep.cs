using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using Newtonsoft.Json.Linq;

namespace Glint.Core
{
    /// <summary>
    /// results.partial of a sweep that is not finished: its identity in the first line,
    /// a row in each line after it, as JSON.
    /// It holds everything that results.json has of the rows, so that a killed sweep loses nothing. Rows that are an
    /// array (<see cref="ResultTable.IsArray"/>) are in their own file alone.
    /// </summary>
    sealed class UnfinishedSweep
    {
        readonly ResultTable _table;

        UnfinishedSweep(ResultTable table, DateTime startedUtc, SweepIdentity identity) =>
            (_table, StartedUtc, Identity) = (table, startedUtc, identity);

        /// <summary>First start of the sweep.</summary>
        public DateTime StartedUtc { get; }

        public SweepIdentity Identity { get; }

        public List<StoredRow> Rows { get; } = new List<StoredRow>();

        /// <summary>Bytes up to the end of the first line, and of each row.</summary>
        public List<long> Ends { get; } = new List<long>();

        /// <summary>
        /// Reads the file. An incomplete last line, left by an interrupted program, is ignored.
        /// </summary>
        /// <returns>Null if the first line is incomplete.</returns>
        /// <exception cref="GlintException">
        /// It cannot be read or is of a newer schema, or a whole line is damaged; the message names it.
        /// </exception>
        public static UnfinishedSweep Read(string path)
        {
            UnfinishedSweep sweep = null;
            int line = 0;
            try
            {
                var bytes = File.ReadAllBytes(path);
                for (int from = 0, end; (end = Array.IndexOf(bytes, (byte)'\n', from)) >= 0; from = end + 1)
                {
                    line++;
                    var json = StoredRun.Parse(Encoding.UTF8.GetString(bytes, from, end - from));
                    if (sweep == null)
                    {
                        StoredRun.CheckSchema(json, path);
                        sweep = new UnfinishedSweep(StoredRun.TableOf(json), StoredRun.Time(json),
                            StoredRun.Identity(json["sweep"] as JObject
                                ?? throw new FormatException("it names no sweep")));
                    }
                    else
                        sweep.Rows.Add(new StoredRow(json, sweep._table));
                    sweep.Ends.Add(end + 1);
                }
                sweep?.AddArray(path);
                return sweep;
            }
            catch (Exception error) when (StoredRun.IsUnreadable(error))
            {
                throw StoredRun.Damaged(line == 0 ? path : StoredRun.InLine(path, line), error);
            }
        }

        void AddArray(string path)
        {
            if (_table.IsArray)
                Rows.AddRange(RowArray.Read(Path.Combine(Path.GetDirectoryName(path), _table.CsvName), _table));
        }
    }
}
