using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Threading;
using System.Threading.Tasks;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>
    /// The amplitude of infinitely many rays in double precision: cells of the picture are divided where the rays
    /// through their corners meet other triangles, clipped where a border separates two of them, and integrated by
    /// Gauss's rules, whose rays are traced.
    /// </summary>
    public sealed class ReferenceAmplitude
    {
        // A cell whose corners meet other triangles and receive nothing is divided this often: returns smaller than
        // its parts are not found. One with a border at most so often.
        const int EmptyDepth = 2, MaxDepth = 7;

        // Bisections of a side: positions have 53 binary places.
        const int Bisections = 36;

        // Distance from a border at which it is tested to be straight, as a part of the cell.
        const double Beside = 1e-7;

        // Path difference of corners, in wavelengths, above which a cell is divided: the rules below are good to 1e-5.
        const double MaxStep = 0.25;

        // Gauss's rule for squares, of -1 to 1, exact for polynomials of degree 5.
        static readonly (double At, double Weight)[] s_line =
        {
            (-Math.Sqrt(0.6), 5.0 / 18), (0, 8.0 / 18), (Math.Sqrt(0.6), 5.0 / 18)
        };

        // Radon's rule for triangles, of the same degree: barycentric coordinates of seven points, and their weights.
        static readonly (double3 At, double Weight)[] s_triangle = TrianglePoints().ToArray();

        readonly ReferenceTracer _tracer;
        readonly double _wavelength;

        ReferenceAmplitude(in RadarPose pose) =>
            (_tracer, _wavelength) = (new ReferenceTracer(pose), pose.Settings.Wavelength);

        /// <summary>The sum of phasors, as if the picture had <see cref="RadarResult.NormalRays"/> rays.</summary>
        /// <param name="pose">Of its number of rays only the aspect ratio matters, and where its region is.</param>
        /// <param name="across">Undivided cells across the region.</param>
        /// <param name="progress">Receives the fraction done, 0 to 1, from any thread; may be null.</param>
        /// <param name="cancel">Cancels the work.</param>
        /// <exception cref="OperationCanceledException">It was cancelled.</exception>
        public static Complex Of(in RadarPose pose, int across, IProgress<double> progress = null,
            CancellationToken cancel = default)
        {
            var integral = new ReferenceAmplitude(pose);
            var region = pose.Settings.TracedRegion;
            double2 corner = new double2(region.Left, region.Bottom), size = new double2(region.Width, region.Height);
            int rows = Math.Max(1, (int)Math.Round(across * size.y / size.x));
            double2 cell = size / new int2(across, rows);
            var sums = new Complex[rows];
            int done = 0;
            Parallel.For(0, rows, new ParallelOptions { CancellationToken = cancel }, row =>
            {
                var below = integral.Row(corner + cell * new double2(0, row), across, cell.x);
                var above = integral.Row(corner + cell * new double2(0, row + 1), across, cell.x);
                for (int column = 0; column < across; column++)
                    sums[row] += integral.Integrate(new Cell
                    {
                        Corner = corner + cell * new double2(column, row), Size = cell,
                        Rays = new[] { below[column], below[column + 1], above[column + 1], above[column] }
                    });
                progress?.Report(Interlocked.Increment(ref done) / (double)rows);
            });
            // In the order of the rows: the same on any machine.
            return sums.Aggregate(Complex.Zero, (sum, part) => sum + part)
                * (RadarResult.NormalRays / pose.Settings.RayCount);
        }

        ReferenceRay[] Row(double2 first, int across, double step) =>
            Enumerable.Range(0, across + 1).Select(column => RayAt(first + new double2(step * column, 0))).ToArray();

        // The ray through a point, in pixels from the lower left corner of the picture.
        ReferenceRay RayAt(double2 at) => _tracer.Trace(at.x - 0.5, at.y - 0.5);

        Complex PhasorOf(in ReferenceRay ray) =>
            Complex.FromPolarCoordinates(1, Signal.Phase(ray.PathLength, _wavelength));

        static bool AreSame(in ReferenceRay a, in ReferenceRay b) =>
            a.Received == b.Received && (!a.Received || a.PathHash == b.PathHash);

        Complex Integrate(in Cell cell)
        {
            var rays = cell.Rays;
            bool areSame = AreSame(rays[0], rays[1]) && AreSame(rays[0], rays[2]) && AreSame(rays[0], rays[3]);
            if (areSame && !rays[0].Received)
            {
                long hash = rays[0].PathHash;
                return cell.Depth >= EmptyDepth || rays.All(ray => ray.PathHash == hash) ? 0 : Divide(cell);
            }
            bool isWhole = areSame ? Square(cell, out var sum) : Cut(cell, out sum);
            if (isWhole)
                return sum;
            if (cell.Depth < MaxDepth)
                return Divide(cell);
            sum = 0;
            foreach (var ray in rays)
                if (ray.Received)
                    sum += PhasorOf(ray) * (cell.Size.x * cell.Size.y / 4);
            return sum;
        }

        bool IsFine(ReferenceRay[] rays) =>
            rays.Max(ray => ray.PathLength) - rays.Min(ray => ray.PathLength) < MaxStep * _wavelength;

        Complex Divide(in Cell cell)
        {
            var rays = new ReferenceRay[9];
            double2 half = cell.Size / 2;
            for (int i = 0; i < 9; i++)
                rays[i] = RayAt(cell.Corner + half * new double2(i % 3, i / 3));
            Complex sum = 0;
            for (int i = 0; i < 4; i++)
            {
                int first = i % 2 + 3 * (i / 2);
                sum += Integrate(new Cell
                {
                    Corner = cell.Corner + half * new double2(i % 2, i / 2), Size = half, Depth = cell.Depth + 1,
                    Rays = new[] { rays[first], rays[first + 1], rays[first + 4], rays[first + 3] }
                });
            }
            return sum;
        }

        // False if a ray meets something else, or the phase changes too much.
        bool Square(in Cell cell, out Complex sum)
        {
            sum = 0;
            if (!IsFine(cell.Rays))
                return false;
            foreach (var (x, weightX) in s_line)
                foreach (var (y, weightY) in s_line)
                {
                    var ray = RayAt(cell.Corner + cell.Size * (new double2(x, y) + 1) / 2);
                    if (!AreSame(ray, cell.Rays[0]))
                        return false;
                    sum += PhasorOf(ray) * (weightX * weightY * cell.Size.x * cell.Size.y);
                }
            return true;
        }

        // Cuts a cell along the border that crosses two of its sides; false if there is more in it.
        bool Cut(in Cell cell, out Complex sum)
        {
            sum = 0;
            var corners = cell.Corners();
            var sides = new int[4];
            int count = 0;
            for (int side = 0; side < 4; side++)
                if (!AreSame(cell.Rays[side], cell.Rays[(side + 1) % 4]))
                    sides[count++] = side;
            if (count != 2 || !IsFine(cell.Rays.Where(ray => ray.Received).ToArray()))
                return false;
            int start = sides[0], end = sides[1];
            ReferenceRay before = cell.Rays[start], after = cell.Rays[(start + 1) % 4];
            if (!Cross(corners[start], corners[(start + 1) % 4], before, after, out var first)
                || !Cross(corners[(end + 1) % 4], corners[end], before, after, out var second)
                || !IsStraight(first, second, cell.Size, before, after))
                return false;
            var ahead = new[] { first }.Concat(Enumerable.Range(start + 1, end - start).Select(i => corners[i]))
                .Append(second).ToArray();
            var behind = new[] { second }.Concat(Enumerable.Range(end + 1, 4 - end + start).Select(i => corners[i % 4]))
                .Append(first).ToArray();
            return AddPolygon(ahead, after, ref sum) && AddPolygon(behind, before, ref sum);
        }

        // The point of a side where one path ends and the other begins; false if there is a third.
        bool Cross(double2 from, double2 to, in ReferenceRay before, in ReferenceRay after, out double2 at)
        {
            for (int i = 0; i < Bisections; i++)
            {
                at = (from + to) / 2;
                var ray = RayAt(at);
                if (AreSame(ray, before))
                    from = at;
                else if (AreSame(ray, after))
                    to = at;
                else
                    return false;
            }
            at = (from + to) / 2;
            return true;
        }

        bool IsStraight(double2 first, double2 second, double2 size, in ReferenceRay before, in ReferenceRay after)
        {
            double2 chord = second - first, middle = (first + second) / 2;
            double length = math.length(chord);
            // The part ahead lies to the right of the chord.
            double2 beside = length > 0 ? Beside * size * new double2(chord.y, -chord.x) / length : 0;
            return AreSame(RayAt(middle + beside), after) && AreSame(RayAt(middle - beside), before);
        }

        // Adds a convex polygon, in triangles; false if a ray of it meets something else.
        bool AddPolygon(double2[] corners, in ReferenceRay same, ref Complex sum)
        {
            if (!same.Received)
                return true;
            for (int i = 2; i < corners.Length; i++)
            {
                double2 a = corners[0], b = corners[i - 1] - a, c = corners[i] - a;
                double area = Math.Abs(b.x * c.y - b.y * c.x) / 2;
                foreach (var (at, weight) in s_triangle)
                {
                    var ray = RayAt(a + at.y * b + at.z * c);
                    if (area > 0 && !AreSame(ray, same))
                        return false;
                    sum += PhasorOf(ray) * (weight * area);
                }
            }
            return true;
        }

        static IEnumerable<(double3, double)> TrianglePoints()
        {
            yield return (1.0 / 3, 9.0 / 40);
            double root = Math.Sqrt(15);
            foreach (double sign in new[] { -1.0, 1.0 })
            {
                double near = (6 + sign * root) / 21, far = 1 - 2 * near, weight = (155 + sign * root) / 1200;
                yield return (new double3(far, near, near), weight);
                yield return (new double3(near, far, near), weight);
                yield return (new double3(near, near, far), weight);
            }
        }

        struct Cell
        {
            public double2 Corner, Size; // pixels
            public int Depth;
            public ReferenceRay[] Rays;  // through its corners, in order around it

            public double2[] Corners() => new[]
            {
                Corner, Corner + new double2(Size.x, 0), Corner + Size, Corner + new double2(0, Size.y)
            };
        }
    }
}
