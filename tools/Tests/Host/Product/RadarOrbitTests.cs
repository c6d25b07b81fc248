using Glint.Core;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>The end of a sweep over ranges while an object above the radar is deactivated.</summary>
public sealed class RadarOrbitTests : EngineFixture
{
    [Test]
    public void Radar_WhoseParentIsDeactivatedDuringASweep_StaysWhereItWas()
    {
        Play();
        GameObject plate = GameObject.CreatePrimitive(PrimitiveType.Quad);
        plate.transform.position = new Vector3(0, 0, 20);
        var platform = new GameObject("Platform", typeof(Mover)).transform;
        platform.position = new Vector3(1, 2, 0);
        Transform radar = new GameObject("Radar", typeof(Camera)).transform;
        radar.SetParent(platform, false);
        radar.gameObject.SetActive(false); // it does not trace by itself
        var controller = radar.gameObject.AddComponent<RadarController>();
        controller.Receiver = MeshFileScene.MakeReceiver(radar, false);
        var plan = new SweepPlan((SweepAxis.Range, new double[] { 7, 70 }));
        var drivers = new AxisDrivers(new SweepSetup(controller, plan) { Target = plate.transform });
        drivers.Show(plan[0]);
        Assert.That((radar.position - platform.position).magnitude, Is.GreaterThan(1), "the sweep moved it");

        platform.GetComponent<Mover>().Disabled = drivers.Dispose;
        platform.gameObject.SetActive(false);

        Assert.That(radar != null, "it was not destroyed with the sweep's own object");
        Assert.That((radar.position - platform.position).magnitude, Is.LessThan(1e-5));
        Assert.That(radar.IsChildOf(platform));
        Assert.That(Errors[^1], Is.EqualTo("RadarController of 'Radar' stays below 'Radar Aim', where the sweep put "
            + "it: Unity moves no object while the one above it is deactivated"));
    }
}
