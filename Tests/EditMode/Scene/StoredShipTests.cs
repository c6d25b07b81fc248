using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>The stored mesh equals the one built from its measures. If not, run glint ship.</summary>
    public sealed class StoredShipTests
    {
        [Test]
        public void Ship_Stored_IsWhatItsMeasuresGive()
        {
            const string path = "Packages/com.glint.meshes/Ship/Ship.prefab";
            var prefab = AssetDatabase.LoadAssetAtPath<GameObject>(path);
            Assert.That(prefab != null, $"{path} is missing");
            Assert.That(prefab.GetComponent<Ship>().Settings, Is.EqualTo(ShipSettings.Default));
            var expected = ShipModel.Build(ShipSettings.Default);
            var mesh = prefab.GetComponent<MeshFilter>().sharedMesh;
            Assert.That(mesh.vertices.Select(v => (float3)v), Is.EqualTo(expected.Vertices));
            Assert.That(mesh.triangles, Is.EqualTo(expected.Indices));
        }
    }
}
