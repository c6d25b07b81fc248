using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Patches, their corners and outlines, and materials of a scene on the device: what the tracing of rays does not need.
    /// </summary>
    sealed class SurfaceBuffers : IDisposable
    {
        /// <summary>Steps of a table of reflection coefficients: REFLECTION_STEPS.</summary>
        public const int ReflectionSteps = 1024;

        /// <summary>Rows of an instance's place: PLACE_ROWS.</summary>
        public const int PlaceRows = 4;

        // Of lengths relative to coordinates: some steps of float32.
        const double Rounding = 1e-6;

        RadarScene _scene;
        double _frequency;
        bool _arePlaced;

        /// <summary>Patches of the scene's instances.</summary>
        public PatchBuffers Patches { get; } = new PatchBuffers();

        public DeviceBuffer<float4> Motions { get; } = new DeviceBuffer<float4>("motions of instances");
        public DeviceBuffer<float4> Reflections { get; } = new DeviceBuffer<float4>("reflection coefficients");

        public DeviceBuffer<float4> Vertices { get; } = new DeviceBuffer<float4>("corners of patches");

        public int VertexCount { get; private set; }

        /// <summary>Sides of triangles on the outlines of patches, with the third corner.</summary>
        public DeviceBuffer<float4> Sides { get; } = new DeviceBuffer<float4>("outlines of patches");

        public int SideCount { get; private set; }

        /// <summary>Of all sides, metres.</summary>
        public double LengthOfSides { get; private set; }

        /// <summary>About the triangles of each mesh, in its frame, in the order of <see cref="PatchBuffers.Facets"/>.</summary>
        public DeviceBuffer<float4> Spheres { get; } = new DeviceBuffer<float4>("spheres about triangles");

        /// <summary>From each mesh's frame to the scene's centre, <see cref="PlaceRows"/> an instance.</summary>
        public DeviceBuffer<float4> Places { get; } = new DeviceBuffer<float4>("places of instances");

        public int InstanceCount { get; private set; }

        public int TriangleCount { get; private set; }

        /// <summary>What casts the shadows of receivers; none where only the radar receives.</summary>
        public SilhouetteBuffers Silhouettes { get; } = new SilhouetteBuffers();

        /// <summary>What the radar may see in mirrors; none where only first bounces count.</summary>
        public MirrorBuffers Mirrors { get; } = new MirrorBuffers();

        /// <summary>Corners, outlines, their pieces or triangles, whichever are most: threads a pose that marks them.</summary>
        public int MarkedCount => Math.Max(Math.Max(TriangleCount, Mirrors.PieceCount),
            Math.Max(SideCount, VertexCount));

        /// <summary>Uploads what has changed.</summary>
        /// <param name="frequency">Of the reflection coefficients, hertz.</param>
        public void Set(RadarScene scene, double3 centre, double creaseDegrees, double frequency)
        {
            bool isSame = _scene != null && scene.IsSame(_scene);
            _arePlaced = !Patches.Set(scene, creaseDegrees) && _arePlaced;
            if (!_arePlaced)
                SetPlaces(scene, centre);
            _arePlaced = true;
            if (!isSame || frequency != _frequency)
                Reflections.Upload(scene.Surfaces.SelectMany(surface => TableOf(surface, frequency)).ToArray());
            (_scene, _frequency) = (scene, frequency);
        }

        public void Dispose()
        {
            Patches.Dispose();
            Vertices.Dispose();
            Sides.Dispose();
            Spheres.Dispose();
            Places.Dispose();
            Silhouettes.Dispose();
            Mirrors.Dispose();
            Motions.Dispose();
            Reflections.Dispose();
            _scene = null;
        }

        void SetPlaces(RadarScene scene, double3 centre)
        {
            var vertices = new List<float4>();
            var sides = new List<float4>();
            var spheres = new List<float4>();
            var withSpheres = new HashSet<SurfacePatches>();
            LengthOfSides = 0;
            for (int i = 0; i < scene.Instances.Length; i++)
            {
                var instance = scene.Instances[i];
                var patches = Patches.OfInstances[i];
                foreach (float3 corner in patches.Corners)
                    vertices.Add(new float4((float3)(instance.ToWorld.Point(corner) - centre), 0));
                AddSides(new PlacedPatches(instance, patches), centre, sides);
                if (withSpheres.Add(patches))
                    spheres.AddRange(SpheresOf(instance.Mesh));
            }
            SideCount = sides.Count / TubeKernels.SideRows;
            Sides.Upload(sides.ToArray());
            Spheres.Upload(spheres.ToArray());
            Places.Upload(scene.Instances.SelectMany(instance => PlaceOf(instance.ToWorld, centre)).ToArray());
            (InstanceCount, TriangleCount) = (scene.Instances.Length, Patches.Parts.TriangleCount);
            VertexCount = vertices.Count;
            Vertices.Upload(vertices.ToArray());
            Motions.Upload(scene.Instances.SelectMany(instance => new[]
            {
                new float4((float3)instance.Motion.VelocityAt(centre), 0),
                new float4((float3)instance.Motion.AngularVelocity, 0)
            }).ToArray());
        }

        void AddSides(in PlacedPatches placed, double3 centre, List<float4> sides)
        {
            foreach (int side in placed.Patches.Outlines)
            {
                double3 start = placed.Point(side), end = placed.Point(WeldedMesh.EndOf(side));
                foreach (var point in new[] { start, end, placed.Point(WeldedMesh.Opposite(side)) })
                    sides.Add(new float4((float3)(point - centre), 0));
                LengthOfSides += math.distance(start, end);
            }
        }

        // About the triangles, in the mesh's frame.
        static IEnumerable<float4> SpheresOf(TriangleMesh mesh)
        {
            for (int triangle = 0; triangle < mesh.TriangleCount; triangle++)
            {
                mesh.GetTriangle(triangle, out var a, out var b, out var c);
                double3 middle = ((double3)a + b + c) / 3;
                double radius = Math.Max(math.distance(middle, a),
                    Math.Max(math.distance(middle, b), math.distance(middle, c)));
                yield return new float4((float3)middle, (float)(radius + Rounding * math.length(middle)));
            }
        }

        // The rows of the matrix, and beside it the stretch of lengths and what rounding on the device adds to them, metres.
        static float4[] PlaceOf(in Affine toWorld, double3 centre)
        {
            double3 x = toWorld.X, y = toWorld.Y, z = toWorld.Z, origin = toWorld.Origin - centre;
            // Of the products of the axes the largest sum of a row is the square of the stretch at least, and equal to it where
            // the axes remain perpendicular.
            double3 xs = new double3(math.dot(x, x), math.dot(x, y), math.dot(x, z)),
                ys = new double3(math.dot(y, x), math.dot(y, y), math.dot(y, z)),
                zs = new double3(math.dot(z, x), math.dot(z, y), math.dot(z, z));
            double square = Math.Max(math.csum(math.abs(xs)), Math.Max(math.csum(math.abs(ys)), math.csum(math.abs(zs))));
            return new[]
            {
                RowOf(x.x, y.x, z.x, origin.x), RowOf(x.y, y.y, z.y, origin.y), RowOf(x.z, y.z, z.z, origin.z),
                RowOf(Math.Sqrt(square), Rounding * math.length(origin), 0, 0)
            };
        }

        static float4 RowOf(double x, double y, double z, double w) => (float4)new double4(x, y, z, w);

        static IEnumerable<float4> TableOf(SurfaceMaterial surface, double frequency)
        {
            for (int i = 0; i <= ReflectionSteps; i++)
            {
                var reflection = surface.Reflection((double)i / ReflectionSteps, frequency);
                yield return new float4((float)reflection.S.Real, (float)reflection.S.Imaginary,
                    (float)reflection.P.Real, (float)reflection.P.Imaginary);
            }
        }
    }
}
