using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>The facets of a sea on the device: those of one tile, and the tiles.</summary>
    sealed class SeaBuffers : IDisposable
    {
        TriangleMesh _mesh;
        IReadOnlyList<bool> _breaking;
        IReadOnlyList<double> _winds;
        IReadOnlyList<double3> _velocities;
        FacetTable _table;

        public DeviceBuffer<SeaFacet> Facets { get; } = new DeviceBuffer<SeaFacet>("facets of a sea");
        public DeviceBuffer<SeaTileRecord> Tiles { get; } = new DeviceBuffer<SeaTileRecord>("tiles of a sea");
        public DeviceBuffer<float4> Velocities { get; } = new DeviceBuffer<float4>("velocities of facets");
        public DeviceBuffer<float4> Table { get; } = new DeviceBuffer<float4>("elements of a table of facets");

        public DeviceBuffer<float4> Levels { get; } = new DeviceBuffer<float4>("levels of a sea");

        /// <summary>Numbers of the facets that break.</summary>
        public DeviceBuffer<uint> Breaking { get; } = new DeviceBuffer<uint>("breaking facets of a sea");

        public int BreakingCount { get; private set; }

        /// <summary>Uploads what has changed.</summary>
        /// <param name="tiles">In the order of the buffer.</param>
        /// <param name="centre">Origin of the kernels' coordinates.</param>
        /// <param name="frequency">Of the table, hertz.</param>
        /// <param name="areMoving">Whether velocities are read.</param>
        /// <param name="statistics">Receives the bytes.</param>
        public void Set(RadarScene scene, RadarSea sea, IEnumerable<SeaTileInstance> tiles, double3 centre,
            double frequency, bool areMoving, TraceStatistics statistics)
        {
            var mesh = scene.Instances[sea.Tiles[0].Instance].Mesh;
            var breaking = sea.Clutter.BreakingFacets;
            var winds = sea.Clutter.LogWinds;
            if (mesh != _mesh || breaking != _breaking || winds != _winds)
                Upload(Facets, FacetsOf(mesh, breaking, winds), statistics);
            if (breaking != _breaking)
            {
                uint[] numbers = Enumerable.Range(0, breaking.Count).Where(i => breaking[i]).Select(i => (uint)i).ToArray();
                Upload(Breaking, numbers, statistics);
                BreakingCount = numbers.Length;
            }
            // Those of an earlier pulse stay: poses may read them in turns.
            var velocities = areMoving ? sea.Clutter.FacetVelocities : _velocities ?? Array.Empty<double3>();
            if (velocities != _velocities)
                Upload(Velocities, velocities.Select(velocity => new float4((float3)velocity, 0)).ToArray(), statistics);
            _velocities = velocities;
            var table = sea.Clutter.TableAt(frequency);
            if (table != _table)
                SeaSigma.Upload(table, Table);
            (_mesh, _breaking, _winds, _table) = (mesh, breaking, winds, table);
            Upload(Tiles, tiles.Select(tile =>
                RecordOf(scene.Instances[tile.Instance].ToWorld, centre, NumberOf(tile.Number))).ToArray(), statistics);
        }

        public void Dispose()
        {
            Facets.Dispose();
            Tiles.Dispose();
            Velocities.Dispose();
            Table.Dispose();
            Levels.Dispose();
            Breaking.Dispose();
            (_mesh, _breaking, _winds, _velocities, _table) = (null, null, null, null, null);
        }

        static void Upload<T>(DeviceBuffer<T> buffer, T[] elements, TraceStatistics statistics) where T : struct
        {
            buffer.Upload(elements);
            statistics.BytesUploaded += (long)elements.Length * buffer.Stride;
        }

        // Facets look up, whichever way the triangles turn.
        static SeaFacet[] FacetsOf(TriangleMesh mesh, IReadOnlyList<bool> breaking, IReadOnlyList<double> winds)
        {
            var facets = new SeaFacet[mesh.TriangleCount];
            for (int i = 0; i < facets.Length; i++)
            {
                mesh.GetTriangle(i, out var a, out var b, out var c);
                double3 section = 0.5 * math.cross((double3)b - a, (double3)c - a);
                facets[i] = new SeaFacet
                {
                    Centre = (float3)(((double3)a + b + c) / 3), IsBreaking = breaking[i] ? 1u : 0,
                    Section = (float3)(section.y < 0 ? -section : section), LogWind = (float)winds[i / 2]
                };
            }
            return facets;
        }

        // Sections transform by the cofactors, and stay upwards in a mirroring transform.
        static SeaTileRecord RecordOf(in Affine toWorld, double3 centre, int number)
        {
            double sign = toWorld.Determinant < 0 ? -1 : 1;
            double3 origin = toWorld.Origin - centre, x = sign * math.cross(toWorld.Y, toWorld.Z),
                y = sign * math.cross(toWorld.Z, toWorld.X), z = sign * math.cross(toWorld.X, toWorld.Y);
            return new SeaTileRecord
            {
                X = (float4)new double4(toWorld.X.x, toWorld.Y.x, toWorld.Z.x, origin.x),
                Y = (float4)new double4(toWorld.X.y, toWorld.Y.y, toWorld.Z.y, origin.y),
                Z = (float4)new double4(toWorld.X.z, toWorld.Y.z, toWorld.Z.z, origin.z),
                SectionX = new float3((float)x.x, (float)y.x, (float)z.x),
                SectionY = new float3((float)x.y, (float)y.y, (float)z.y),
                SectionZ = new float3((float)x.z, (float)y.z, (float)z.z), Number = number
            };
        }

        // Seas of 65,536 tiles and more across repeat their speckle.
        static int NumberOf(int2 tile) => tile.x << 16 | tile.y & 0xffff;
    }
}
