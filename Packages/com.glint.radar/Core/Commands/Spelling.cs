using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Core
{
    /// <summary>Suggests the intended name for a misspelt one.</summary>
    public static class Spelling
    {
        /// <summary>The known name nearest to a word; null if none is near.</summary>
        public static string Nearest(string word, IEnumerable<string> names)
        {
            var near = names.Select(name => (name, distance: name.StartsWith(word, StringComparison.Ordinal)
                    && word.Length > 1 ? 0 : Distance(word, name)))
                .OrderBy(pair => pair.distance).FirstOrDefault();
            return near.name != null && near.distance <= Math.Max(1, word.Length / 3) ? near.name : null;
        }

        // Levenshtein distance, one row of the table at a time.
        static int Distance(string from, string to)
        {
            var row = Enumerable.Range(0, to.Length + 1).ToArray();
            for (int i = 1; i <= from.Length; i++)
            {
                int diagonal = row[0];
                row[0] = i;
                for (int j = 1; j <= to.Length; j++)
                {
                    int replaced = diagonal + (from[i - 1] == to[j - 1] ? 0 : 1);
                    diagonal = row[j];
                    row[j] = Math.Min(replaced, Math.Min(row[j], row[j - 1]) + 1);
                }
            }
            return row[to.Length];
        }
    }
}
