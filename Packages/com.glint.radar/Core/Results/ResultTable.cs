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
            FolderSuffix = "-rcs", ArraysName = "rcs.npz", WriteArrays = CrossSectionArrays.Write
        };

        /// <summary>Every table.</summary>
        public static readonly IReadOnlyList<ResultTable> All = new[] { Sweep, CrossSection };

        ResultTable(string name, string csvName, IReadOnlyList<ResultColumn> columns) =>
            (Name, CsvName, Columns) = (name, csvName, columns);

        /// <summary>Name of the command that writes it.</summary>
        public string Name { get; }

        /// <summary>File of the rows.</summary>
        public string CsvName { get; }

        /// <summary>Ends the name of the default folder; null for nothing.</summary>
        public string FolderSuffix { get; private set; }

        /// <summary>The columns, in the order of the files.</summary>
        public IReadOnlyList<ResultColumn> Columns { get; }

        /// <summary>Whether each row has timings.</summary>
        public bool HasTimings { get; private set; }

        /// <summary>
        /// File of the rows as arrays; null for none. A part of a sweep does not have it, its merged whole does.
        /// </summary>
        public string ArraysName { get; private set; }

        /// <summary>Writes the arrays of a whole sweep from its identity and rows.</summary>
        internal Action<Stream, SweepIdentity, IReadOnlyList<StoredRow>> WriteArrays { get; private set; }

        /// <summary>The table of a name in results.json; null: that of sweeps.</summary>
        /// <exception cref="FormatException">There is no such table.</exception>
        internal static ResultTable Find(string name) => name == null ? Sweep
            : All.FirstOrDefault(table => table.Name == name)
                ?? throw new FormatException($"its table is {Values.Shown(name)}");
    }
}
