using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// Identity of a sweep: its poses, scene and settings, the device and the versions, each as a name and a text.
    /// Rows of equal identities belong together.
    /// </summary>
    public sealed class SweepIdentity
    {
        /// <summary>Name of the hash of the scene.</summary>
        public const string Content = "content";

        /// <summary>Name of the place of the target, in the hierarchy and the world. Earlier versions did not write it.</summary>
        public const string TargetPlace = "target_place";

        readonly List<KeyValuePair<string, string>> _entries = new List<KeyValuePair<string, string>>();

        /// <summary>Names and texts in the order of the file; each name once, a text may be null.</summary>
        public IReadOnlyList<KeyValuePair<string, string>> Entries => _entries;

        /// <summary>The part of the sweep; null for all of it.</summary>
        public SweepShard? Shard { get; set; }

        /// <summary>Adds an entry.</summary>
        public void Add(string name, string text) => _entries.Add(new KeyValuePair<string, string>(name, text));

        /// <summary>The same sweep, another part of it.</summary>
        internal SweepIdentity WithShard(SweepShard? shard)
        {
            var other = new SweepIdentity { Shard = shard };
            other._entries.AddRange(_entries);
            return other;
        }

        /// <summary>
        /// The first difference from another sweep, such as "frequency was 9 and is 10"; null if there is none.
        /// </summary>
        /// <param name="earlier">The earlier sweep.</param>
        public string DifferenceFrom(SweepIdentity earlier)
        {
            if (!Equals(Shard, earlier.Shard))
                return Difference("shard", earlier.Shard?.ToString(), Shard?.ToString());
            foreach (string name in _entries.Concat(earlier._entries).Select(entry => entry.Key).Distinct())
                if (earlier.Find(name) != Find(name) && !(name == TargetPlace && earlier.Find(name) == null))
                    return Difference(name, earlier.Find(name), Find(name));
            return null;
        }

        /// <summary>The text of an entry; null if there is none.</summary>
        public string Find(string name) => _entries.FirstOrDefault(entry => entry.Key == name).Value;

        /// <summary>The numbers of an entry that is a list; null if there is none.</summary>
        /// <exception cref="FormatException">It is damaged.</exception>
        public double[] FindList(string name) => Find(name)?.Split(',')
            .Select(text => double.Parse(text, CultureInfo.InvariantCulture)).ToArray();

        static string Difference(string name, string was, string now)
        {
            if (name == Content)
                return "the meshes, places or materials of the scene are others "
                    + $"({name} was {Shown(was)} and is {Shown(now)})";
            return Shown(was) == Shown(now) ? LongDifference(name, was.Split(','), now.Split(','))
                : $"{name} was {Shown(was)} and is {Shown(now)}";
        }

        // Of texts, or lists, that begin alike.
        static string LongDifference(string name, string[] was, string[] now)
        {
            if (was.Length != now.Length)
                return $"{name} had {was.Length} values and has {now.Length}";
            int first = Enumerable.Range(0, was.Length).First(i => was[i] != now[i]);
            return $"{(was.Length == 1 ? "" : $"value {first + 1} of ")}{name} was {was[first]} and is {now[first]}";
        }

        static string Shown(string text) => text == null ? "not given" : Values.Shown(text);
    }
}
