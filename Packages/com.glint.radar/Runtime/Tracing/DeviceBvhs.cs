using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The mesh BVHs on the device. A mesh that recurs costs nothing; the BVHs of other meshes are dropped.
    /// </summary>
    sealed class DeviceBvhs : IDisposable
    {
        /// <summary>Number of pages of the kernels: _Bvh0 to _Bvh7.</summary>
        public const int MaxPages = 8;

        // Maximum ratio of a buffer's capacity to its content, above a few spare rows; larger buffers are released.
        const int MaxSlack = 4;
        const long SpareRows = 1 << 16;

        // Most that firmware usually reserves for an integrated GPU; GPUs with that little of their own are rare.
        const int MaxReservedMebibytes = 2048;

        readonly BvhLayout _layout;
        readonly string _owner;
        readonly long _maxRowsPerPage;
        readonly List<BvhPage> _pages = new List<BvhPage>();
        readonly Dictionary<TriangleMesh, BvhAllocation> _bvhs = new Dictionary<TriangleMesh, BvhAllocation>();
        bool _hasChanged;

        /// <param name="maxRowsPerPage">Maximum rows of one page; fewer if the device's limit is lower.</param>
        public DeviceBvhs(BvhLayout layout, string owner, long maxRowsPerPage)
        {
            _layout = layout;
            _owner = owner;
            _maxRowsPerPage = Math.Min(maxRowsPerPage, DeviceBuffer<uint4>.MaxCount);
        }

        public BvhAllocation this[TriangleMesh mesh] => _bvhs[mesh];

        public IReadOnlyList<BvhPage> Pages => _pages;

        /// <summary>Bytes of the device's buffers.</summary>
        public long Bytes => Capacity * 16;

        /// <summary>Sets the meshes: builds new BVHs and drops those of other meshes.</summary>
        /// <returns>True if a BVH was built.</returns>
        /// <exception cref="GlintException">
        /// The device cannot hold them. The earlier BVHs are lost, unless this was known before any was built.
        /// </exception>
        /// <exception cref="OperationCanceledException">Building was cancelled; the earlier BVHs are lost.</exception>
        public bool SetMeshes(ICollection<TriangleMesh> meshes, TraceStatistics statistics,
            Func<TriangleMesh, BvhLayout, MeshBvh> build)
        {
            RefuseBefore(meshes);
            try
            {
                Drop(meshes);
                var added = Build(meshes, statistics, build);
                Upload(added, statistics);
                return added.Count > 0;
            }
            catch
            {
                Dispose(); // drops an incomplete set
                throw;
            }
        }

        public void Dispose()
        {
            foreach (var page in _pages)
                page.Dispose();
            _pages.Clear();
            _bvhs.Clear();
        }

        void Drop(ICollection<TriangleMesh> but)
        {
            foreach (var mesh in _bvhs.Keys.Where(mesh => !but.Contains(mesh)).ToList())
            {
                _bvhs[mesh].Free(_pages);
                _bvhs.Remove(mesh);
            }
        }

        List<BvhAllocation> Build(ICollection<TriangleMesh> meshes, TraceStatistics statistics,
            Func<TriangleMesh, BvhLayout, MeshBvh> build)
        {
            var added = new List<BvhAllocation>();
            foreach (var mesh in meshes)
            {
                if (_bvhs.ContainsKey(mesh))
                    continue;
                var allocation = new BvhAllocation(build(mesh, _layout));
                statistics.BvhsBuilt++;
                statistics.TrianglesBuilt += mesh.TriangleCount;
                _bvhs.Add(mesh, allocation);
                added.Add(allocation);
            }
            return added;
        }

        void Upload(List<BvhAllocation> added, TraceStatistics statistics)
        {
            if (_pages.Count == 0 || IsMostlyEmpty || !added.All(allocation => allocation.Allocate(_pages)))
            {
                added = _bvhs.Values.ToList();
                MakePages();
                if (!added.All(allocation => allocation.Allocate(_pages)))
                    throw new InvalidOperationException("BVHs do not fit the buffers made for them");
            }
            statistics.BytesUploaded += added.Sum(allocation => allocation.Rows) * 16;
        }

        // Makes new pages for all BVHs, with spare room if the scene has changed before: it is likely to change again.
        void MakePages()
        {
            foreach (var page in _pages)
                page.Dispose();
            _pages.Clear();
            var parts = _bvhs.Values.SelectMany(allocation => allocation.Bvh.Parts)
                .Select(part => (long)part.Rows.Length).ToList();
            long spare = _hasChanged && parts.Count > 0 ? parts.Sum() / 8 + parts.Max() : 0;
            _hasChanged = true;
            Refuse(parts.Sum(), "");

            var sizes = new List<long> { 0 };
            foreach (long rows in parts)
            {
                if (rows > _maxRowsPerPage)
                    throw TooLarge(parts.Sum(), "");
                if (sizes[sizes.Count - 1] + rows > _maxRowsPerPage)
                    sizes.Add(0);
                sizes[sizes.Count - 1] += rows;
            }
            if (sizes.Count > MaxPages)
                throw TooLarge(parts.Sum(), "");
            // With several pages one more costs nothing.
            if (sizes.Count > 1 && sizes.Count < MaxPages && sizes[sizes.Count - 1] + spare > _maxRowsPerPage
                && (parts.Sum() + spare) * 16 <= MaxBytes)
                sizes.Add(0);
            int last = sizes.Count - 1;
            sizes[last] = Math.Max(1, Math.Min(_maxRowsPerPage, sizes[last] + spare));
            foreach (long rows in sizes)
                _pages.Add(new BvhPage((int)rows));
        }

        long Capacity => _pages.Sum(page => (long)page.Rows.Capacity);

        bool IsMostlyEmpty => Capacity > MaxSlack * _bvhs.Values.Sum(allocation => allocation.Rows) + SpareRows;

        double MaxBytes => Math.Min((double)MaxPages * _maxRowsPerPage * 16,
            UsableMebibytes(SystemInfo.graphicsMemorySize, SystemInfo.systemMemorySize) * 1048576.0);

        /// <summary>
        /// Mebibytes that BVHs may take. A GPU without memory of its own uses the computer's, of which Unity reports
        /// only the part reserved for it.
        /// </summary>
        public static int UsableMebibytes(int graphicsMemory, int systemMemory) =>
            graphicsMemory > MaxReservedMebibytes ? graphicsMemory : Math.Max(graphicsMemory, systemMemory / 2);

        /// <summary>Minimum bytes of the BVHs over some meshes: every triangle reflects and has a partner.</summary>
        public static double MinBytes(IEnumerable<TriangleMesh> meshes, BvhLayout layout) =>
            meshes.Sum(mesh => (double)mesh.TriangleCount) * MeshBvh.MinRowsPerTriangle(layout) * 16;

        // Checks the minimum size before building. Triangles that reflect nothing are not part of it; they are counted
        // only if that decides.
        void RefuseBefore(ICollection<TriangleMesh> meshes)
        {
            double min = MeshBvh.MinRowsPerTriangle(_layout);
            if (MinBytes(meshes, _layout) > MaxBytes)
                Refuse(meshes.Sum(mesh => (double)MeshBvh.CountReflecting(mesh)) * min, "at least ");
        }

        void Refuse(double rows, string bound)
        {
            if (rows * 16 > MaxBytes)
                throw TooLarge(rows, bound);
        }

        GlintException TooLarge(double rows, string bound) =>
            new GlintException($"{_owner}: the BVHs over its meshes take {bound}{Text.Mebibytes(rows * 16)}, "
                + $"and {SystemInfo.graphicsDeviceName} holds {Text.Mebibytes(MaxBytes)} of them in buffers "
                + $"of {Text.Mebibytes(_maxRowsPerPage * 16.0)}: trace fewer triangles (layers, roots), "
                + "or share one mesh among several objects");
    }
}
