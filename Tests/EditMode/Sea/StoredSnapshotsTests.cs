using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>The stored meshes equal those built from their recipe. If not, run glint sea.</summary>
    public sealed class StoredSnapshotsTests
    {
        [Test]
        public void Snapshots_OfEachStoredSea_AreWhatTheirRecipesGive([Values(0, 1)] int number)
        {
            var recipe = StoredSeas.All[number];
            var surface = new SeaSurface(recipe.Settings);
            for (int i = 0; i < recipe.Times.Count; i++)
            {
                var stored = Load(recipe, i);
                Assert.That(stored.Settings, Is.EqualTo(recipe.Settings));
                Assert.That(stored.TimeSeconds, Is.EqualTo(recipe.Times[i]));
                Assert.That(stored.WaveHeight, Is.EqualTo(surface.MeasuredWaveHeight(recipe.Times[i])));
                var expected = surface.Mesh(recipe.Times[i]);
                Assert.That(stored.Tile.vertices.Select(v => (float3)v), Is.EqualTo(expected.Vertices),
                    $"{recipe.Name}, {stored.name}");
                Assert.That(stored.Tile.triangles, Is.EqualTo(expected.Indices));
            }
        }

        [Test]
        public void Snapshots_OfEachStoredSea_AreTwoTilesAlongTheView([Values(0, 1)] int number)
        {
            var recipe = StoredSeas.All[number];
            Assert.That(recipe.Times.Count, Is.EqualTo(10));
            for (int i = 0; i < 10; i++)
            {
                var stored = Load(recipe, i);
                var tiles = stored.GetComponentsInChildren<MeshFilter>(true);
                Assert.That(tiles.Select(tile => tile.transform.localPosition),
                    Is.EqualTo(new[] { new Vector3(0, 0, -32), new Vector3(0, 0, 32) }));
                Assert.That(tiles.Select(tile => tile.sharedMesh), Is.All.SameAs(stored.Tile));
                Assert.That(tiles.Sum(tile => tile.sharedMesh.triangles.Length / 3), Is.EqualTo(35344));
                Assert.That(stored.Tile.vertices.Min(v => v.z), Is.EqualTo(-32).Within(6),
                    "displaced by less than 6 m");
            }
        }

        // Undisplaced vertices form a regular grid, so the variance of their heights is that of the waves. The last
        // row and column repeat the first.
        [TestCase(0, 2.5)]
        [TestCase(1, 6)]
        public void Snapshots_Together_HaveTheWaveHeightAskedFor(int number, double asked)
        {
            var recipe = StoredSeas.All[number];
            Assert.That(recipe.Settings.SignificantWaveHeight, Is.EqualTo(asked));
            int side = recipe.Settings.Cells + 1;
            var heights = Enumerable.Range(0, 10).SelectMany(i => Load(recipe, i)
                .Tile.vertices.Where((v, at) => at % side < side - 1 && at / side < side - 1))
                .Select(v => (double)v.y).ToArray();
            Assert.That(heights.Average(), Is.Zero.Within(1e-3));
            Assert.That(4 * math.sqrt(heights.Average(y => y * y)), Is.EqualTo(asked).Within(2).Percent);
        }

        static SeaSnapshot Load(SeaRecipe recipe, int index)
        {
            string path = $"Packages/com.glint.meshes/{recipe.Name}/Snapshot {index + 1:00}.prefab";
            var prefab = AssetDatabase.LoadAssetAtPath<GameObject>(path);
            Assert.That(prefab != null, $"{path} is missing");
            return prefab.GetComponent<SeaSnapshot>();
        }
    }
}
