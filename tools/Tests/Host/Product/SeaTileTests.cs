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

    [Test]
    public void Motion_OfASeaThatCannotBeShown_IsReportedOnce()
    {
        Play();
        Sea sea = Asleep("Sea").AddComponent<Sea>();
        sea.Motion = SeaMotion.Waves;
        sea.Snapshots.Add(null);
        sea.gameObject.SetActive(true);
        Steps(5);
        Assert.That(Errors, Has.Exactly(1).Contains("its motion is Waves"));
        sea.Snapshots.Clear();
        sea.Rebuild();
        float before = (float)sea.TimeSeconds;
        Steps(2);
        Assert.That(sea.TimeSeconds, Is.GreaterThan(before));
        Assert.That(Tiles, Is.Not.Empty);
    }

    static MeshRenderer[] Tiles =>
        Object.FindObjectsByType<MeshRenderer>(FindObjectsInactive.Exclude, FindObjectsSortMode.None);
}
