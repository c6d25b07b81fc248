using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>
    /// Targets whose radar cross section is known. Sizes are in metres. The descriptions have right-handed axes with z
    /// up, as the published cases; the meshes have Unity's axes, (x, y, z) become (x, z, y), and keep outer sides.
    /// Corners at the same position share a vertex.
    /// </summary>
    public static class CrossSectionTargets
    {
        /// <summary>The shape of a trihedral's faces.</summary>
        public enum TrihedralFace
        {
            /// <summary>Triangles with a right angle at the vertex.</summary>
            Triangular,
            /// <summary>Squares.</summary>
            Square,
            /// <summary>Quarter circles.</summary>
            Circular,
        }

        /// <summary>A thin plate in the plane x = 0, a along y and b along z, normal +x.</summary>
        public static TriangleMesh Plate(double a, double b) => ToMesh(PlateFaces(a, b));

        /// <summary>
        /// Two thin faces, a wide and b high, that meet on the z axis. The first is in the plane y = 0 towards +x; the
        /// second is turned from it towards +y.
        /// </summary>
        /// <param name="a">Width of a face.</param>
        /// <param name="b">Length of the common edge.</param>
        /// <param name="degrees">The angle between the faces.</param>
        public static TriangleMesh Dihedral(double a, double b, double degrees = 90) =>
            ToMesh(DihedralFaces(a, b, degrees));

        /// <summary>
        /// A right-angled dihedral that opens towards +x, turned about the x axis: at 0 its edge is along z.
        /// </summary>
        /// <inheritdoc cref="Dihedral"/>
        public static TriangleMesh DihedralAboutSight(double a, double b, double degrees) =>
            ToMesh(Turned(Turned(DihedralFaces(a, b, 90), 2, -45), 0, degrees));

        /// <summary>Three thin faces in the coordinate planes, vertex at the origin, open towards +x +y +z.</summary>
        /// <param name="edge">Length of the edges at the vertex; the radius of quarter circles.</param>
        /// <param name="face">Shape of the faces.</param>
        /// <param name="steps">Straight pieces of a quarter circle.</param>
        public static TriangleMesh Trihedral(double edge, TrihedralFace face, int steps = 256)
        {
            double3 x = new double3(edge, 0, 0), y = new double3(0, edge, 0), z = new double3(0, 0, edge);
            return ToMesh(new[]
            {
                TrihedralOutline(x, y, face, steps), TrihedralOutline(y, z, face, steps),
                TrihedralOutline(z, x, face, steps),
            });
        }

        /// <summary>A sphere about the origin: the surface of a cube, cut into squares and blown up.</summary>
        /// <param name="radius">Radius of the corners.</param>
        /// <param name="cuts">Squares along an edge of the cube: 12 cuts^2 triangles.</param>
        public static TriangleMesh Sphere(double radius, int cuts)
        {
            var faces = new List<double3[]>();
            for (int axis = 0; axis < 3; axis++)
                for (int side = -1; side <= 1; side += 2)
                    for (int i = 0; i < cuts; i++)
                        for (int j = 0; j < cuts; j++)
                        {
                            double3 At(int u, int v)
                            {
                                var point = default(double3);
                                point[axis] = side;
                                point[(axis + 1) % 3] = side * math.tan(math.PI_DBL / 4 * (2.0 * u / cuts - 1));
                                point[(axis + 2) % 3] = math.tan(math.PI_DBL / 4 * (2.0 * v / cuts - 1));
                                return radius * math.normalize(point);
                            }
                            faces.Add(new[] { At(i, j), At(i + 1, j), At(i + 1, j + 1), At(i, j + 1) });
                        }
            return ToMesh(faces);
        }

        /// <summary>A cylinder about the z axis, its middle at the origin.</summary>
        /// <param name="radius">Radius of the corners.</param>
        /// <param name="height">Height.</param>
        /// <param name="sides">Flat sides, equal.</param>
        /// <param name="caps">Whether it is closed; without caps it is a thin tube.</param>
        public static TriangleMesh Cylinder(double radius, double height, int sides, bool caps)
        {
            double3[] low = Ring(radius, -height / 2, sides), high = Ring(radius, height / 2, sides);
            var faces = new List<double3[]>();
            for (int i = 0, j = 1; i < sides; i++, j = (i + 1) % sides)
                faces.Add(new[] { low[i], low[j], high[j], high[i] });
            if (caps)
            {
                Array.Reverse(low);
                faces.Add(high);
                faces.Add(low);
            }
            return ToMesh(faces);
        }

        /// <summary>
        /// A dihedral without its corner: two thin plates, a wide and b high, turned by 45 degrees towards each other,
        /// open to +x.
        /// </summary>
        /// <param name="a">Width of a plate.</param>
        /// <param name="b">Height along z.</param>
        /// <param name="gap">Distance of the plates' middles along y.</param>
        public static TriangleMesh TwoPlates(double a, double b, double gap) => ToMesh(Joined(
            Moved(Turned(PlateFaces(a, b), 2, 45), new double3(0, -gap / 2, 0)),
            Moved(Turned(PlateFaces(a, b), 2, -45), new double3(0, gap / 2, 0))));

        /// <summary>A thin square plate in x = <paramref name="distance"/> before another one in x = 0.</summary>
        /// <param name="front">Side of the plate in front.</param>
        /// <param name="back">Side of the plate behind.</param>
        /// <param name="distance">Distance of the plates.</param>
        public static TriangleMesh HiddenPlate(double front, double back, double distance) => ToMesh(
            Joined(PlateFaces(back, back), Moved(PlateFaces(front, front), new double3(distance, 0, 0))));

        /// <summary>
        /// A closed box about the origin, <paramref name="thickness"/> along x, a along y and b along z.
        /// </summary>
        public static TriangleMesh Box(double a, double b, double thickness)
        {
            double3 P(int i, int j, int k) => new double3(i * thickness, j * a, k * b) / 2;
            return ToMesh(new[]
            {
                new[] { P(1, -1, -1), P(1, 1, -1), P(1, 1, 1), P(1, -1, 1) },
                new[] { P(-1, -1, -1), P(-1, -1, 1), P(-1, 1, 1), P(-1, 1, -1) },
                new[] { P(-1, 1, -1), P(-1, 1, 1), P(1, 1, 1), P(1, 1, -1) },
                new[] { P(-1, -1, -1), P(1, -1, -1), P(1, -1, 1), P(-1, -1, 1) },
                new[] { P(-1, -1, 1), P(1, -1, 1), P(1, 1, 1), P(-1, 1, 1) },
                new[] { P(-1, -1, -1), P(-1, 1, -1), P(1, 1, -1), P(1, -1, -1) },
            });
        }

        /// <summary>
        /// A thin tube about the z axis from z = 0 up, on a thin disc in z = 0, which has a hole inside the tube.
        /// </summary>
        /// <param name="radius">Radius of the tube.</param>
        /// <param name="height">Height of the tube.</param>
        /// <param name="disc">Radius of the disc.</param>
        /// <param name="sides">Flat sides of the tube.</param>
        public static TriangleMesh TopHat(double radius, double height, double disc, int sides)
        {
            double3[] foot = Ring(radius, 0, sides), top = Ring(radius, height, sides), rim = Ring(disc, 0, sides);
            var faces = new List<double3[]>();
            for (int i = 0, j = 1; i < sides; i++, j = (i + 1) % sides)
            {
                faces.Add(new[] { foot[i], foot[j], top[j], top[i] });
                faces.Add(new[] { foot[i], rim[i], rim[j], foot[j] });
            }
            return ToMesh(faces);
        }

        /// <summary>The target of the published cases with a given name.</summary>
        /// <exception cref="ArgumentException">No target has this name.</exception>
        public static TriangleMesh Named(string name) => name switch
        {
            "plate_0p3_0p2" => Plate(0.3, 0.2),
            "plate_0p5_0p5" => Plate(0.5, 0.5),
            "dihedral_0p3_0p2" => Dihedral(0.3, 0.2),
            "dihedral_los_0" => DihedralAboutSight(0.3, 0.2, 0),
            "dihedral_los_22p5" => DihedralAboutSight(0.3, 0.2, 22.5),
            "dihedral_los_45" => DihedralAboutSight(0.3, 0.2, 45),
            "dihedral_100deg" => Dihedral(0.3, 0.2, 100),
            "trihedral_triangular_0p3" => Trihedral(0.3, TrihedralFace.Triangular),
            "trihedral_square_0p3" => Trihedral(0.3, TrihedralFace.Square),
            "trihedral_circular_0p3" => Trihedral(0.3, TrihedralFace.Circular),
            "trihedral_triangular_1" => Trihedral(1, TrihedralFace.Triangular),
            "sphere_1" => Sphere(1, 128),
            "cylinder_0p1_0p5" => Cylinder(0.1, 0.5, 1440, true),
            "cylinder_0p5_0p3" => Cylinder(0.5, 0.3, 2880, true),
            "two_plates" => TwoPlates(0.2, 0.2, 0.3),
            "hidden_plate" => HiddenPlate(0.2, 0.4, 0.5),
            "top_hat" => TopHat(0.1, 0.2, 0.6, 720),
            _ => throw new ArgumentException($"no target of the cross-section cases is called '{name}'", nameof(name)),
        };

        static double3[][] PlateFaces(double a, double b)
        {
            double3 P(int j, int k) => new double3(0, j * a, k * b) / 2;
            return new[] { new[] { P(-1, -1), P(1, -1), P(1, 1), P(-1, 1) } };
        }

        static double3[][] DihedralFaces(double a, double b, double degrees)
        {
            // A right angle is exact, without the cosine's rounding.
            double sin = math.sin(math.radians(degrees)), cos = degrees == 90 ? 0 : math.cos(math.radians(degrees));
            double3 low = new double3(0, 0, -b / 2), high = new double3(0, 0, b / 2), across = new double3(a, 0, 0),
                turned = a * new double3(cos, sin, 0);
            return new[]
            {
                new[] { low, high, high + across, low + across }, new[] { low, low + turned, high + turned, high },
            };
        }

        static double3[] TrihedralOutline(double3 u, double3 v, TrihedralFace face, int steps)
        {
            if (face == TrihedralFace.Triangular)
                return new[] { double3.zero, u, v };
            if (face == TrihedralFace.Square)
                return new[] { double3.zero, u, u + v, v };
            var outline = new double3[steps + 2];
            outline[1] = u;
            outline[steps + 1] = v;
            for (int i = 1; i < steps; i++)
            {
                double angle = math.PI_DBL / 2 * i / steps;
                outline[i + 1] = math.cos(angle) * u + math.sin(angle) * v;
            }
            return outline;
        }

        static double3[] Ring(double radius, double z, int sides)
        {
            var ring = new double3[sides];
            for (int i = 0; i < sides; i++)
            {
                double angle = 2 * math.PI_DBL * i / sides;
                ring[i] = new double3(radius * math.cos(angle), radius * math.sin(angle), z);
            }
            return ring;
        }

        // Turned about axis 0, 1 or 2 by the right-hand rule.
        static double3[][] Turned(double3[][] faces, int axis, double degrees)
        {
            double cos = math.cos(math.radians(degrees)), sin = math.sin(math.radians(degrees));
            int i = (axis + 1) % 3, j = (axis + 2) % 3;
            return Each(faces, p =>
            {
                var turned = p;
                turned[i] = cos * p[i] - sin * p[j];
                turned[j] = sin * p[i] + cos * p[j];
                return turned;
            });
        }

        static double3[][] Moved(double3[][] faces, double3 by) => Each(faces, p => p + by);

        static double3[][] Each(double3[][] faces, Converter<double3, double3> change) =>
            Array.ConvertAll(faces, face => Array.ConvertAll(face, change));

        static double3[][] Joined(double3[][] first, double3[][] second)
        {
            var faces = new double3[first.Length + second.Length][];
            first.CopyTo(faces, 0);
            second.CopyTo(faces, first.Length);
            return faces;
        }

        // Convex polygons, cut into triangles from their first corner.
        static TriangleMesh ToMesh(IEnumerable<double3[]> faces)
        {
            var numbers = new Dictionary<float3, int>();
            var vertices = new List<float3>();
            var indices = new List<int>();
            int Number(double3 p)
            {
                // Corners that rounding alone keeps apart are one vertex, also beside 0.
                var position = (float3)(math.round(p * 1e12).xzy / 1e12) + 0f;
                if (!numbers.TryGetValue(position, out int number))
                {
                    numbers.Add(position, number = vertices.Count);
                    vertices.Add(position);
                }
                return number;
            }
            foreach (var face in faces)
                for (int i = 2; i < face.Length; i++)
                {
                    // Exchanging two axes mirrors: the corners change their order so that outer sides stay.
                    indices.Add(Number(face[0]));
                    indices.Add(Number(face[i]));
                    indices.Add(Number(face[i - 1]));
                }
            return new TriangleMesh(vertices.ToArray(), indices.ToArray());
        }
    }
}
