using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// The entry points of cells. <see cref="TracerTests"/> shows that they change no result. This shows their saving:
    /// the nodes above an entry point are opened once for its cell instead of by each of its rays.
    /// </summary>
    public sealed class EntryPointsTests
    {
        // DONE in Shaders/BinaryBvh.hlsl.
        const uint None = uint.MaxValue;

        static readonly RadarSettings s_settings = TestRadar.Settings(333, 187);
        static readonly RadarView s_view = TestRadar.LookAt(double3(9, 10, 11), 0, fov: 40);

        [Test]
        public void FindEntryPoints_OfEveryCell_AreLevelsBelowTheRoot(
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            var mesh = TestRadar.Clutter(5000, seed: 5, halfSide: 4, largest: 0.3f);
            var layout = asSoftware ? BvhLayout.Wide : BvhLayout.Binary;
            var levels = Levels(MeshBvh.Build(mesh, layout).Parts[0].Rows, layout);
            var cells = FindEntryPoints(mesh, asSoftware).Where(starts => starts.x != None).ToArray();
            Assert.That(cells.Length, Is.GreaterThan(300), "cells that may meet something");
            foreach (var starts in cells)
                for (int i = 0; i < 4 && starts[i] != None; i++)
                    if (!levels.ContainsKey(starts[i]))
                        Assert.Fail($"{starts[i]:x} refers to no node or leaf");
            // For a BVH of 8 or 15 levels; measured 3.62 and 6.62.
            Assert.That(cells.Average(starts => Enumerable.Range(0, 4).Where(i => starts[i] != None)
                .Average(i => levels[starts[i]])), Is.GreaterThan(asSoftware ? 3.4 : 6.3));
        }

        // Four entry points for each cell: here one tile.
        static uint4[] FindEntryPoints(TriangleMesh mesh, bool asSoftware)
        {
            var kernel = new TraceKernel(TestKernels.Trace, asSoftware, "test");
            using (var scene = new DeviceScene(asSoftware ? BvhLayout.Wide : BvhLayout.Binary, "test", long.MaxValue))
            using (var cells = new DeviceBuffer<uint>("cells"))
            using (var starts = new DeviceBuffer<uint4>("starts"))
            {
                scene.Set(new RadarScene(mesh), new TraceStatistics(), (some, layout) => MeshBvh.Build(some, layout));
                var picture = new PictureTiles(s_settings, s_view);
                scene.AddTo(picture);
                var traced = picture.ToCells(asSoftware);
                cells.Upload(traced.Corners);
                var plan = new DispatchPlan(s_settings, RayReadback.None, traced, true, new DispatchPacer(),
                    int.MaxValue);
                Assert.That(plan.Next() && plan.Cells == traced.Corners.Length);
                starts.Reserve(plan.Cells * DeviceScene.MaxInlineInstances);
                kernel.Choose(scene, false);
                kernel.SetRadar(s_settings, s_view, new RayGrid(s_settings, s_view, scene.Min, scene.Max),
                    scene.Scene.Origin, 1, Culling.All);
                kernel.SetScene(scene);
                kernel.SetCellSize(traced.Size);
                kernel.FindEntryPoints(scene, cells, plan, starts);
                var found = new uint4[plan.Cells * DeviceScene.MaxInlineInstances];
                starts.ReadBack(found, found.Length);
                return found.Where((_, i) => i % DeviceScene.MaxInlineInstances == 0).ToArray();
            }
        }

        // Number of nodes above each reference of a BVH.
        static Dictionary<uint, int> Levels(uint4[] rows, BvhLayout layout)
        {
            bool isWide = layout == BvhLayout.Wide;
            var levels = new Dictionary<uint, int> { [isWide ? 8u : DeviceScene.InstanceBvhRootRow] = 0 };
            var waiting = new Queue<uint>(levels.Keys);
            while (waiting.Count > 0)
            {
                uint node = waiting.Dequeue();
                foreach (uint child in isWide ? WideChildren(rows, node) : BinaryChildren(rows, node))
                {
                    levels[child] = levels[node] + 1;
                    waiting.Enqueue(child);
                }
            }
            return levels;
        }

        static uint[] BinaryChildren(uint4[] rows, uint node) =>
            node >> 31 == 1 ? new uint[0] : new[] { rows[node].w, rows[node + 1].w };

        // A reference is a word of the traversal's stack: record << 12 | 8 | 4 for a leaf.
        static uint[] WideChildren(uint4[] rows, uint node)
        {
            if ((node & 4) != 0)
                return new uint[0];
            uint row = 3 * (node >> 12), masks = rows[row].w, first = rows[row + 2].z;
            return new uint[] { 0, 1, 2, 3 }.Where(child => (masks >> (28 + (int)child) & 1) != 0)
                .Select(child => (first + child) << 12 | 8 | (masks >> (24 + (int)child) & 1) << 2).ToArray();
        }
    }
}
