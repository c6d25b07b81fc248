using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>
    /// A reproducible scene for benchmarks: a rough sea, 128 x 128 m about the origin, and a ship-like body on it, 60 m
    /// long, broadside on to +-Z. Rays bounce between waves, hull and superstructure. It has no sea spectrum and is no
    /// real ship.
    /// </summary>
    public sealed class SeaAndShip
    {
        const double SeaSide = 128;

        const int Waves = 32;
        const double LongestWave = 48, ShortestWave = 3;

        // Amplitude over wavelength of the steepest waves: the longest is 0.4 m high.
        const double Steepness = 0.0085;

        /// <summary>Makes the sea and the ship.</summary>
        /// <param name="seed">Seed of the waves.</param>
        /// <param name="seaTriangles">Triangles of the sea, rounded to a square grid.</param>
        /// <param name="shipTriangles">Triangles of the ship, rounded to the grids of its bodies.</param>
        public SeaAndShip(int seed, int seaTriangles, int shipTriangles)
        {
            Sea = MakeSea(seed, math.max(1, (int)math.round(math.sqrt(seaTriangles / 2.0))));
            Ship = MakeShip(shipTriangles);
        }

        /// <summary>An open surface over the XZ plane.</summary>
        public TriangleMesh Sea { get; }

        /// <summary>Four intersecting closed bodies: every edge belongs to two triangles.</summary>
        public TriangleMesh Ship { get; }

        static TriangleMesh MakeSea(int seed, int cells)
        {
            var waves = MakeWaves((uint)seed);
            int side = cells + 1;
            // sin(a + b) from the sines and cosines of each axis, without a sine for each vertex and wave.
            double[] alongX = Phases(waves, side, wave => wave.AlongX, wave => 0),
                alongZ = Phases(waves, side, wave => wave.AlongZ, wave => wave.Phase);
            var vertices = new float3[side * side];
            for (int z = 0; z < side; z++)
                for (int x = 0; x < side; x++)
                {
                    double height = 0;
                    for (int w = 0, atX = 2 * Waves * x, atZ = 2 * Waves * z; w < Waves; w++, atX += 2, atZ += 2)
                        height += waves[w].Amplitude * (alongX[atX] * alongZ[atZ + 1] + alongX[atX + 1] * alongZ[atZ]);
                    vertices[z * side + x] =
                        new float3((float)Coordinate(x, cells), (float)height, (float)Coordinate(z, cells));
                }

            var indices = new int[6 * cells * cells];
            int at = 0;
            for (int z = 0; z < cells; z++)
                for (int x = 0; x < cells; x++)
                {
                    int corner = z * side + x;
                    AddTriangle(indices, ref at, corner, corner + side, corner + 1);
                    AddTriangle(indices, ref at, corner + 1, corner + side, corner + side + 1);
                }
            return new TriangleMesh(vertices, indices);
        }

        static double Coordinate(int step, int cells) => SeaSide * ((double)step / cells - 0.5);

        // Sine and cosine of each wave's phase at each step along an axis.
        static double[] Phases(Wave[] waves, int side, Func<Wave, double> waveNumber, Func<Wave, double> phase)
        {
            var phases = new double[2 * waves.Length * side];
            for (int step = 0; step < side; step++)
                for (int w = 0; w < waves.Length; w++)
                {
                    double angle = waveNumber(waves[w]) * Coordinate(step, side - 1) + phase(waves[w]);
                    phases[2 * (step * waves.Length + w)] = math.sin(angle);
                    phases[2 * (step * waves.Length + w) + 1] = math.cos(angle);
                }
            return phases;
        }

        // Wavelengths in a geometric series, random directions and phases, heights proportional to the wavelength.
        static Wave[] MakeWaves(uint seed)
        {
            uint state = seed;
            double Next()
            {
                // The generator of Numerical Recipes: the same on every machine. Its low bits are poor; the quotient
                // uses the high ones.
                state = state * 1664525u + 1013904223u;
                return state / 4294967296.0;
            }
            Next();

            var waves = new Wave[Waves];
            for (int w = 0; w < Waves; w++)
            {
                double length = LongestWave * math.pow(ShortestWave / LongestWave, w / (Waves - 1.0));
                double direction = 2 * math.PI_DBL * Next(), number = 2 * math.PI_DBL / length;
                waves[w] = new Wave
                {
                    Amplitude = Steepness * length * (0.25 + 0.75 * Next()),
                    AlongX = number * math.cos(direction),
                    AlongZ = number * math.sin(direction),
                    Phase = 2 * math.PI_DBL * Next(),
                };
            }
            return waves;
        }

        static TriangleMesh MakeShip(int triangles)
        {
            var vertices = new List<float3>();
            var indices = new List<int>();
            AddEllipsoid(vertices, indices, new Ellipsoid
            {
                Centre = new double3(0, 0.5, 0), HalfSize = new double3(30, 4, 5), Roundness = new double2(0.6, 0.75)
            }, 0.55 * triangles);
            AddEllipsoid(vertices, indices, new Ellipsoid
            {
                Centre = new double3(-5, 6, 0), HalfSize = new double3(9, 3.5, 3.5), Roundness = new double2(0.3, 0.35)
            }, 0.25 * triangles);
            AddEllipsoid(vertices, indices, new Ellipsoid
            {
                Centre = new double3(9, 5, 0), HalfSize = new double3(4, 2.5, 2.5), Roundness = new double2(0.5, 0.5)
            }, 0.14 * triangles);
            AddEllipsoid(vertices, indices, new Ellipsoid
            {
                Centre = new double3(-4, 12, 0), HalfSize = new double3(0.8, 5, 0.8), Roundness = new double2(0.4, 1)
            }, 0.06 * triangles);
            return new TriangleMesh(vertices.ToArray(), indices.ToArray());
        }

        // A superellipsoid in rings from its top to its bottom point, with twice as many steps around as down.
        static void AddEllipsoid(List<float3> vertices, List<int> indices, Ellipsoid part, double triangles)
        {
            int stacks = math.max(3, (int)math.round(0.5 + math.sqrt(0.25 + triangles / 4)));
            int slices = math.max(3, (int)math.round(triangles / (2 * (stacks - 1))));
            int top = vertices.Count, bottom = top + 1, rings = top + 2;
            vertices.Add(part.Point(0, 0));
            vertices.Add(part.Point(math.PI_DBL, 0));
            for (int stack = 1; stack < stacks; stack++)
                for (int slice = 0; slice < slices; slice++)
                    vertices.Add(part.Point(math.PI_DBL * stack / stacks, 2 * math.PI_DBL * slice / slices));

            for (int slice = 0; slice < slices; slice++)
            {
                int here = rings + slice, next = rings + (slice + 1) % slices;
                AddTriangle(indices, top, next, here);
                for (int stack = 1; stack < stacks - 1; stack++, here += slices, next += slices)
                {
                    AddTriangle(indices, here, next, here + slices);
                    AddTriangle(indices, next, next + slices, here + slices);
                }
                AddTriangle(indices, bottom, here, next);
            }
        }

        static void AddTriangle(int[] indices, ref int at, int a, int b, int c)
        {
            indices[at++] = a;
            indices[at++] = b;
            indices[at++] = c;
        }

        static void AddTriangle(List<int> indices, int a, int b, int c)
        {
            indices.Add(a);
            indices.Add(b);
            indices.Add(c);
        }

        struct Wave
        {
            public double Amplitude, AlongX, AlongZ, Phase;
        }

        struct Ellipsoid
        {
            public double3 Centre, HalfSize;

            // Exponents down and around: 1 is an ellipsoid, towards 0 a box.
            public double2 Roundness;

            public float3 Point(double down, double about)
            {
                double ring = Power(math.sin(down), Roundness.x);
                return (float3)(Centre + HalfSize * new double3(
                    ring * Power(math.cos(about), Roundness.y), Power(math.cos(down), Roundness.x),
                    ring * Power(math.sin(about), Roundness.y)));
            }

            static double Power(double value, double exponent) =>
                Math.Sign(value) * math.pow(math.abs(value), exponent);
        }
    }
}
