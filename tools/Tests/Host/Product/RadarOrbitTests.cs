using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Glint.Host.Tests;

/// <summary>Sweeps over ranges among other scenes and objects.</summary>
public sealed class RadarOrbitTests : EngineFixture
{
    [Test]
    public void Radar_WhoseParentIsDeactivatedDuringASweep_StaysWhereItWas()
    {
        Play();
        GameObject plate = Plate();
        var platform = new GameObject("Platform", typeof(Mover)).transform;
        platform.position = new Vector3(1, 2, 0);
        Transform radar = Radar();
        radar.SetParent(platform, false);
        var drivers = Sweep(radar, plate);
        Assert.That((radar.position - platform.position).magnitude, Is.GreaterThan(1), "the sweep moved it");

        platform.GetComponent<Mover>().Disabled = drivers.Dispose;
        platform.gameObject.SetActive(false);

        Assert.That(radar != null, "it was not destroyed with the sweep's own object");
        Assert.That((radar.position - platform.position).magnitude, Is.LessThan(1e-5));
        Assert.That(radar.IsChildOf(platform));
        Assert.That(Errors[^1], Is.EqualTo("RadarController of 'Radar' stays below 'Radar Aim', where the sweep put "
            + "it: Unity moves no object while the one above it is deactivated"));
    }

    // The active scene is that of new objects, and of those that leave their parent.
    [Test]
    public void Radar_OfASceneThatIsNotActive_StaysInIt()
    {
        Play();
        GameObject plate = Plate();
        Transform radar = Radar();
        Scene own = radar.gameObject.scene, active = SceneManager.CreateScene("Active");
        SceneManager.SetActiveScene(active);
        var drivers = Sweep(radar, plate);
        Assert.That(radar.gameObject.scene, Is.EqualTo(own));
        drivers.Dispose();
        Assert.That(radar.gameObject.scene, Is.EqualTo(own));
        Assert.That((radar.parent, active.rootCount), Is.EqualTo(((Transform)null, 0)));
    }

    [Test]
    public void Radar_DestroyedDuringASweep_LeavesNothingBehind()
    {
        Play();
        GameObject plate = Plate();
        Transform radar = Radar();
        var drivers = Sweep(radar, plate);
        Assert.That(GameObject.Find("Radar Aim"), Is.Not.Null);
        Object.DestroyImmediate(radar.gameObject);
        drivers.Dispose();
        Assert.That(GameObject.Find("Radar Aim"), Is.Null);
    }

    static GameObject Plate()
    {
        GameObject plate = GameObject.CreatePrimitive(PrimitiveType.Quad);
        plate.transform.position = new Vector3(0, 0, 20);
        return plate;
    }

    // Inactive: it does not trace by itself.
    static Transform Radar()
    {
        Transform radar = new GameObject("Radar", typeof(Camera)).transform;
        radar.gameObject.SetActive(false);
        var controller = radar.gameObject.AddComponent<RadarController>();
        controller.Receiver = MeshFileScene.MakeReceiver(radar, false);
        return radar;
    }

    // At its first pose.
    static AxisDrivers Sweep(Transform radar, GameObject target)
    {
        var plan = new SweepPlan((SweepAxis.Range, new double[] { 7, 70 }));
        var drivers = new AxisDrivers(
            new SweepSetup(radar.GetComponent<RadarController>(), plan) { Target = target.transform });
        drivers.Show(plan[0]);
        return drivers;
    }
}
