using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace Glint.Core
{
    /// <summary>
    /// The contributions of a row in results.json: lists of numbers, in the order of <see cref="Polarisation.All"/>,
    /// null where nothing was asked for.
    /// </summary>
    static class ContributionsJson
    {
        /// <summary>Name in a row.</summary>
        public const string Name = "contributions";

        const string Objects = "objects", Bounces = "bounces", HotSpots = "hot_spots";

        /// <summary>
        /// Writes objects and bounces, each its number and real and imaginary parts, and hot spots, each its object,
        /// its triangle and levels.
        /// </summary>
        public static void Write(JsonTextWriter json, CrossSectionContributions contributions)
        {
            json.WriteStartObject();
            Write(json, Objects, contributions.Objects.Select(Numbers));
            Write(json, Bounces, contributions.Bounces.Select(Numbers));
            Write(json, HotSpots, contributions.HotSpots.Select(spot =>
                new double?[] { spot.Object, spot.Triangle }.Concat(spot.Dbsm)));
            json.WriteEndObject();
        }

        /// <summary>Reads what was written; null for a row without contributions.</summary>
        /// <exception cref="FormatException">It is damaged.</exception>
        public static CrossSectionContributions Read(JToken json)
        {
            if (json == null)
                return null;
            double?[][] objects = Lists(json, Objects, 9), bounces = Lists(json, Bounces, 9),
                spots = Lists(json, HotSpots, 6);
            return new CrossSectionContributions(objects.Select(ToContribution).ToArray(),
                bounces.Select(ToContribution).ToArray(), spots.Select(spot =>
                    new HotSpot((int)spot[0].Value, (int)spot[1].Value, spot.Skip(2).ToArray())).ToArray());
        }

        static IEnumerable<double?> Numbers(Contribution contribution) =>
            new double?[] { contribution.Number }.Concat(Polarisation.All
                .Select(polarisation => polarisation.Of(contribution.S))
                .SelectMany(amplitude => double.IsNaN(amplitude.Real)
                    ? new double?[2]
                    : new double?[] { amplitude.Real, amplitude.Imaginary }));

        static Contribution ToContribution(double?[] numbers) => new Contribution((int)numbers[0].Value,
            ScatteringMatrix.Of(Enumerable.Range(0, 4).Select(i => new Complex(
                numbers[1 + 2 * i] ?? double.NaN, numbers[2 + 2 * i] ?? double.NaN)).ToArray()));

        static void Write(JsonTextWriter json, string name, IEnumerable<IEnumerable<double?>> lists)
        {
            json.WritePropertyName(name);
            json.WriteStartArray();
            foreach (var list in lists)
            {
                json.WriteStartArray();
                foreach (double? number in list)
                    json.WriteRawValue(number is double value ? Core.Numbers.Format(value) : "null");
                json.WriteEndArray();
            }
            json.WriteEndArray();
        }

        static double?[][] Lists(JToken json, string name, int length)
        {
            var lists = (json as JObject)?[name] as JArray
                ?? throw new FormatException($"{Name} of a row has no {name}");
            return lists.Select(list => list is JArray numbers && numbers.Count == length
                    && numbers[0].Type == JTokenType.Integer
                    && (name != HotSpots || numbers[1].Type == JTokenType.Integer)
                ? numbers.Select(number => number.Value<double?>()).ToArray()
                : throw new FormatException($"{name} of a row are not lists of {length} numbers")).ToArray();
        }
    }
}
