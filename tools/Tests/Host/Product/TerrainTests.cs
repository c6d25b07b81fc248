using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>A radar says that it does not trace terrains.</summary>
public sealed class TerrainTests
{
    [Test]
    public void Gather_OfATerrain_WarnsOfItWhereTheRadarWouldSeeIt()
    {
        var root = new GameObject("Land").transform;
        var coast = new GameObject("Coast").AddComponent<Terrain>();
        coast.transform.SetParent(root);
        try
        {
            string[] Warnings(LayerMask layers)
            {
                var gatherer = new SceneGatherer();
                gatherer.Gather(layers, new[] { root }, null);
                return gatherer.Warnings.ToArray();
            }
            Assert.That(Warnings(~0),
                Is.EqualTo(new[] { "terrains are not traced: 'Coast'. Make meshes of them to include them" }));
            Assert.That(Warnings(1 << 5), Is.Empty);
            coast.enabled = false;
            Assert.That(Warnings(~0), Is.Empty);
        }
        finally
        {
            Object.DestroyImmediate(root.gameObject);
        }
    }
}
