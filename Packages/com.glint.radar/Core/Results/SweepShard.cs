using System;
using System.Globalization;

namespace Glint.Core
{
    /// <summary>Part K of N of a sweep: consecutive poses, in parts whose sizes differ by at most one.</summary>
    public readonly struct SweepShard
    {
        /// <summary>Maximum number of parts of a sweep.</summary>
        public const int Limit = 100000;

        /// <summary>A part.</summary>
        /// <param name="number">From 1 to <paramref name="count"/>.</param>
        public SweepShard(int number, int count) =>
            (Number, Count) = (number, count);

        /// <summary>Number of the part, from 1.</summary>
        public int Number { get; }

        /// <summary>Number of parts.</summary>
        public int Count { get; }

        /// <summary>The first pose of the part.</summary>
        /// <param name="poses">Poses of the whole sweep.</param>
        public int First(int poses) => (int)((long)poses * (Number - 1) / Count);

        /// <summary>The first pose after the part.</summary>
        /// <param name="poses">Poses of the whole sweep.</param>
        public int End(int poses) => (int)((long)poses * Number / Count);

        /// <summary>Reads K/N.</summary>
        /// <exception cref="FormatException">Malformed or out of range.</exception>
        public static SweepShard Parse(string text)
        {
            var parts = text.Split('/');
            if (parts.Length != 2 || !TryRead(parts[0], out int number) || !TryRead(parts[1], out int count)
                || number < 1 || number > count || count > Limit)
                throw new FormatException(FormattableString.Invariant(
                    $"must be K/N, part K of N, such as 2/8, with K from 1 to N and N at most {Limit}"));
            return new SweepShard(number, count);
        }

        /// <summary>"2/8".</summary>
        public override string ToString() => FormattableString.Invariant($"{Number}/{Count}");

        static bool TryRead(string text, out int number) =>
            int.TryParse(text.Trim(), NumberStyles.None, CultureInfo.InvariantCulture, out number);
    }
}
