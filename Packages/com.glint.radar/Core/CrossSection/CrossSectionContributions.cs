using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Core
{
    /// <summary>What the parts of a scene contribute to one cross section: their amplitudes add up to S.</summary>
    public sealed class CrossSectionContributions
    {
        /// <summary>Maximum number of objects; the rest of a scene's is summed up as <see cref="Others"/>.</summary>
        public const int MaxObjects = 64;

        /// <summary>Number in place of an object for all objects that have no number of their own.</summary>
        public const int Others = MeshRange.NoObject;

        /// <summary>Maximum number of <see cref="HotSpots"/>.</summary>
        public const int MaxHotSpots = 256;

        /// <summary>Decibels below the strongest triangle down to which triangles are hot spots.</summary>
        public const double HotSpotRange = 40;

        /// <summary>Maximum number of triangles of a scene: 256 MiB of sums on the device.</summary>
        public const int MaxTriangles = 1 << 22;

        /// <summary>Those of an empty scene.</summary>
        public static readonly CrossSectionContributions None =
            new CrossSectionContributions(new Contribution[0], new Contribution[0], new HotSpot[0]);

        /// <summary>The contributions of some parts.</summary>
        public CrossSectionContributions(IReadOnlyList<Contribution> objects, IReadOnlyList<Contribution> bounces,
            IReadOnlyList<HotSpot> hotSpots) => (Objects, Bounces, HotSpots) = (objects, bounces, hotSpots);

        /// <summary>
        /// By the object whose currents or edges radiate, the strongest first, then <see cref="Others"/> if any.
        /// </summary>
        public IReadOnlyList<Contribution> Objects { get; }

        /// <summary>By the number of bounces; 0: the fringe fields of edges.</summary>
        public IReadOnlyList<Contribution> Bounces { get; }

        /// <summary>The triangles whose currents radiate most, the strongest first.</summary>
        public IReadOnlyList<HotSpot> HotSpots { get; }

        /// <summary>What is wrong with the contributions of a stored row; null: nothing.</summary>
        /// <param name="contributions">Null: the row has none.</param>
        /// <param name="objects">Number of objects of the scene.</param>
        public static string ProblemOf(CrossSectionContributions contributions, int objects)
        {
            if (contributions == null)
                return "has no contributions";
            foreach (int number in contributions.Objects.Select(each => each.Number)
                .Concat(contributions.HotSpots.Select(spot => spot.Object)))
                if (number != Others && (number < 0 || number >= objects))
                    return $"has a contribution of object {number} of {objects}";
            return null;
        }

        /// <summary>The contributions that are written.</summary>
        /// <param name="parts">The parts of the scene.</param>
        /// <param name="objects">S of each of its objects, in their order.</param>
        /// <param name="s">S of a part.</param>
        /// <param name="polarisations">Those that were asked for.</param>
        public static CrossSectionContributions Of(SceneParts parts, IReadOnlyList<ScatteringMatrix> objects,
            Func<int, ScatteringMatrix> s, IReadOnlyList<Polarisation> polarisations)
        {
            double Strength(ScatteringMatrix of) =>
                polarisations.Max(polarisation => polarisation.Of(of).Magnitude);
            var known = objects.Select((of, i) => (Number: parts.Objects[i], S: of))
                .OrderBy(each => each.Number == Others).ThenByDescending(each => Strength(each.S)).ToArray();
            int kept = Math.Min(MaxObjects, known.Count(each => each.Number != Others));
            var written = known.Take(kept).ToList();
            if (known.Length > kept)
                written.Add((Others,
                    known.Skip(kept).Aggregate(default(ScatteringMatrix), (sum, each) => sum + each.S)));
            var triangles = Enumerable.Range(0, parts.TriangleCount).Select(part => (part, strength: Strength(s(part))))
                .OrderByDescending(each => each.strength).Take(MaxHotSpots).ToArray();
            double weakest = triangles.Length == 0 ? 0 : triangles[0].strength * Math.Pow(10, -HotSpotRange / 20);
            return new CrossSectionContributions(
                written.Select(each => new Contribution(each.Number, each.S.Only(polarisations))).ToArray(),
                Enumerable.Range(0, RadarSettings.BounceLimit + 1)
                    .Select(bounces => new Contribution(bounces, s(parts.FirstBounce + bounces).Only(polarisations)))
                    .Where(each => polarisations.Any(polarisation => polarisation.Of(each.S) != 0)).ToArray(),
                triangles.Where(each => each.strength > 0 && each.strength >= weakest)
                    .Select(each => new HotSpot(parts.TriangleOf(each.part), s(each.part).Only(polarisations)))
                    .ToArray());
        }
    }

    /// <summary>What an object, or the tubes with a number of bounces, contribute.</summary>
    public readonly struct Contribution
    {
        /// <summary>A contribution.</summary>
        public Contribution(int number, in ScatteringMatrix s) => (Number, S) = (number, s);

        /// <summary>Number of the object, or of bounces.</summary>
        public int Number { get; }

        /// <summary>Metres; NaN where it was not asked for.</summary>
        public ScatteringMatrix S { get; }
    }

    /// <summary>A triangle that returns much: the coherent sum over it.</summary>
    public readonly struct HotSpot
    {
        const int Decimals = 2;

        /// <summary>A hot spot from what was stored.</summary>
        /// <param name="dbsm">In the order of <see cref="Polarisation.All"/>.</param>
        public HotSpot(int objectNumber, int triangle, IReadOnlyList<double?> dbsm) =>
            (Object, Triangle, Dbsm) = (objectNumber, triangle, dbsm);

        internal HotSpot((int Object, int Triangle) of, ScatteringMatrix s) : this(of.Object, of.Triangle,
            Polarisation.All.Select(polarisation => Rounded(ScatteringMatrix.Dbsm(polarisation.Of(s)))).ToArray())
        {
        }

        /// <summary>Number of the object.</summary>
        public int Object { get; }

        /// <summary>Number of the triangle in the object, from 0.</summary>
        public int Triangle { get; }

        /// <summary>
        /// Cross section of the triangle's currents, dBsm, rounded to 0.01, in the order of
        /// <see cref="Polarisation.All"/>; null where it is 0 or was not asked for.
        /// </summary>
        public IReadOnlyList<double?> Dbsm { get; }

        static double? Rounded(double dbsm) =>
            double.IsNaN(dbsm) || double.IsInfinity(dbsm) ? (double?)null : Math.Round(dbsm, Decimals);
    }
}
