using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Glint.Host.Tests;

/// <summary>The tiles of a sea as objects of the scene.</summary>
public sealed class SeaTileTests : EngineFixture
{
    [Test]
    public void Tiles_OfASea_DoNotChangeItsScene()
    {
        new GameObject("Sea").AddComponent<Sea>();
        Assert.That(Tiles, Is.Not.Empty);
        Assert.That(SceneManager.GetActiveScene().isDirty, Is.False);

        new GameObject("Child").transform.SetParent(Tiles[0].transform.parent);
        Assert.That(SceneManager.GetActiveScene().isDirty, "an object that is saved");
    }

    static MeshRenderer[] Tiles =>
        Object.FindObjectsByType<MeshRenderer>(FindObjectsInactive.Exclude, FindObjectsSortMode.None);
}
