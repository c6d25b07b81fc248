using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The trees over meshes on the device. A mesh that comes again costs nothing;
    /// those that do not come again are dropped.
    /// </summary>
    sealed class DeviceTrees : IDisposable
    {
        /// <summary>Buffers that the kernel can read trees from: _Tree0 to _Tree7.</summary>
        public const int MostBanks = 8;

        // Buffers larger than so many times what is in them are given back, beyond a few that nobody misses.
        const int MostEmptiness = 4;
        const long FewRows = 1 << 16;

        readonly TreeShape _shape;
        readonly string _owner;
        readonly long _mostRowsABank;
        readonly List<TreeBank> _banks = new List<TreeBank>();
        readonly Dictionary<TriangleMesh, PlacedTree> _trees = new Dictionary<TriangleMesh, PlacedTree>();
        bool _hasChanged;

        /// <param name="mostRowsABank">Rows that one buffer may hold; fewer if the device holds fewer.</param>
        public DeviceTrees(TreeShape shape, string owner, long mostRowsABank)
        {
            _shape = shape;
            _owner = owner;
            _mostRowsABank = Math.Min(mostRowsABank, DeviceBuffer<uint4>.Most);
        }

        public PlacedTree this[TriangleMesh mesh] => _trees[mesh];

        public IReadOnlyList<TreeBank> Banks => _banks;

        /// <summary>Bytes of the device's buffers.</summary>
        public long Bytes => Capacity * 16;

        /// <summary>Holds the trees of these meshes from now on, and no others: builds those that are new.</summary>
        /// <returns>True if any was built.</returns>
        /// <exception cref="GlintException">
        /// The device cannot hold them; the trees before are lost unless that was plain before any was built.
        /// </exception>
        /// <exception cref="OperationCanceledException">Building was cancelled; the trees before are lost.</exception>
        public bool Hold(ICollection<TriangleMesh> meshes, TraceStatistics statistics,
            Func<TriangleMesh, TreeShape, MeshTree> build)
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
                Dispose(); // half of it would be worse than nothing
                throw;
            }
        }

        public void Dispose()
        {
            foreach (var bank in _banks)
                bank.Dispose();
            _banks.Clear();
            _trees.Clear();
        }

        void Drop(ICollection<TriangleMesh> but)
        {
            foreach (var mesh in _trees.Keys.Where(mesh => !but.Contains(mesh)).ToList())
            {
                _trees[mesh].Free(_banks);
                _trees.Remove(mesh);
            }
        }

        List<PlacedTree> Build(ICollection<TriangleMesh> meshes, TraceStatistics statistics,
            Func<TriangleMesh, TreeShape, MeshTree> build)
        {
            var added = new List<PlacedTree>();
            foreach (var mesh in meshes)
            {
                if (_trees.ContainsKey(mesh))
                    continue;
                var tree = new PlacedTree(build(mesh, _shape));
                statistics.TreesBuilt++;
                statistics.TrianglesBuilt += mesh.TriangleCount;
                _trees.Add(mesh, tree);
                added.Add(tree);
            }
            return added;
        }

        void Upload(List<PlacedTree> added, TraceStatistics statistics)
        {
            if (_banks.Count == 0 || IsMostlyEmpty || !added.All(tree => tree.Place(_banks)))
            {
                added = _trees.Values.ToList();
                MakeBanks();
                if (!added.All(tree => tree.Place(_banks)))
                    throw new InvalidOperationException("trees do not fit the buffers made for them");
            }
            statistics.BytesUploaded += added.Sum(tree => tree.Rows) * 16;
        }

        // New buffers for all trees. A scene that has changed once will do so again:
        // then there is room for its next mesh.
        void MakeBanks()
        {
            foreach (var bank in _banks)
                bank.Dispose();
            _banks.Clear();
            var parts = _trees.Values.SelectMany(tree => tree.Tree.Parts)
                .Select(part => (long)part.Words.Length).ToList();
            long spare = _hasChanged && parts.Count > 0 ? parts.Sum() / 8 + parts.Max() : 0;
            _hasChanged = true;
            Refuse(parts.Sum(), "");

            var sizes = new List<long> { 0 };
            foreach (long rows in parts)
            {
                if (rows > _mostRowsABank)
                    throw TooLarge(parts.Sum(), "");
                if (sizes[sizes.Count - 1] + rows > _mostRowsABank)
                    sizes.Add(0);
                sizes[sizes.Count - 1] += rows;
            }
            if (sizes.Count > MostBanks)
                throw TooLarge(parts.Sum(), "");
            // Where there are several buffers anyway, one more costs nothing.
            if (sizes.Count > 1 && sizes.Count < MostBanks && sizes[sizes.Count - 1] + spare > _mostRowsABank
                && (parts.Sum() + spare) * 16 <= MostBytes)
                sizes.Add(0);
            int last = sizes.Count - 1;
            sizes[last] = Math.Max(1, Math.Min(_mostRowsABank, sizes[last] + spare));
            foreach (long rows in sizes)
                _banks.Add(new TreeBank((int)rows));
        }

        long Capacity => _banks.Sum(bank => (long)bank.Rows.Capacity);

        bool IsMostlyEmpty => Capacity > MostEmptiness * _trees.Values.Sum(tree => tree.Rows) + FewRows;

        double MostBytes =>
            Math.Min((double)MostBanks * _mostRowsABank * 16, SystemInfo.graphicsMemorySize * 1048576.0);

        /// <summary>What the trees over some meshes take if every triangle reflects and all are in pairs.</summary>
        public static double LeastBytes(IEnumerable<TriangleMesh> meshes, TreeShape shape) =>
            meshes.Sum(mesh => (double)mesh.TriangleCount) * MeshTree.LeastRowsPerTriangle(shape) * 16;

        // By what the trees take at least, before they are built. Triangles that reflect nothing are not in them;
        // they are counted only if it matters.
        void RefuseBefore(ICollection<TriangleMesh> meshes)
        {
            double least = MeshTree.LeastRowsPerTriangle(_shape);
            if (LeastBytes(meshes, _shape) > MostBytes)
                Refuse(meshes.Sum(mesh => (double)MeshTree.CountReflecting(mesh)) * least, "at least ");
        }

        void Refuse(double rows, string bound)
        {
            if (rows * 16 > MostBytes)
                throw TooLarge(rows, bound);
        }

        GlintException TooLarge(double rows, string bound) =>
            new GlintException($"{_owner}: the trees over its meshes take {bound}{Text.Mebibytes(rows * 16)}, "
                + $"and {SystemInfo.graphicsDeviceName} holds {Text.Mebibytes(MostBytes)} of them in buffers "
                + $"of {Text.Mebibytes(_mostRowsABank * 16.0)}: trace fewer triangles (layers, roots), "
                + "or share one mesh among several objects");
    }
}
