using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Glint.Tests;
using Glint.Vulkan;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host.Tests;

/// <summary>A radar traced in edit mode leaves no buffer on the device when it goes, whatever takes it away.</summary>
public sealed class DeviceMemoryTests : EngineFixture
{
    static readonly (string How, Action<RadarController> Do)[] s_ends =
    {
        ("its object is deleted", radar => Object.DestroyImmediate(radar.gameObject)),
        ("the component is removed", radar => Object.DestroyImmediate(radar)),
        ("the component is disabled", radar => radar.enabled = false),
        ("its object is deactivated", radar => radar.gameObject.SetActive(false)),
        ("its creation is undone", _ => Undo.PerformUndo()),
        ("another scene is opened", _ => EditorSceneManager.NewScene(NewSceneSetup.EmptyScene)),
        ("scripts are reloaded", _ => AssemblyReloadEvents.Reload()),
        ("play mode begins", _ => Engine.EnterPlayMode()),
    };

    static IEnumerable<TestCaseData> Ends => s_ends.Select(end => new TestCaseData(end.Do).SetArgDisplayNames(end.How));

    static IEnumerable<Type> Behaviours => typeof(RadarController).Assembly.GetTypes()
        .Where(type => !type.IsAbstract && type.IsSubclassOf(typeof(MonoBehaviour)));

    ComputeShader _kernel;

    [OneTimeSetUp]
    public void LoadKernel() => _kernel = TestKernels.Trace;

    [TestCaseSource(nameof(Ends))]
    public void Buffers_OfARadarTracedInEditMode_AreReleasedWhen(Action<RadarController> end)
    {
        GameObject plate = GameObject.CreatePrimitive(PrimitiveType.Quad);
        (plate.transform.position, plate.transform.localScale) = (new Vector3(0, 0, 20), new Vector3(4, 4, 1));
        var radar = new GameObject("Radar", typeof(Camera)).AddComponent<RadarController>();
        Undo.IncrementCurrentGroup();
        Undo.RegisterCreatedObjectUndo(radar.gameObject, "Create Radar");
        radar.Settings = TestRadar.Settings();
        radar.Receiver = MeshFileScene.MakeReceiver(radar.transform, false);
        radar.Kernel = _kernel;
        GpuBuffer[] before = GraphicsDevice.Current.Buffers.ToArray();

        Assert.That(radar.Trace().RaysReceived, Is.GreaterThan(0));
        GpuBuffer[] made = GraphicsDevice.Current.Buffers.Except(before).ToArray();
        Assert.That(made, Is.Not.Empty);
        end(radar);

        Assert.That(made.Count(buffer => !buffer.IsDisposed), Is.Zero);
    }

    // Outside play mode Unity sends OnDisable and OnDestroy to no other script.
    [Test]
    public void Behaviours_ThatOwnBuffers_RunInEditModeToo()
    {
        Type[] owners = Behaviours.Where(type => Owns(type, new HashSet<Type>())).ToArray();
        Assert.That(owners, Has.Member(typeof(RadarController)));
        Assert.That(owners.Where(type => !type.IsDefined(typeof(ExecuteAlways))), Is.Empty);
    }

    [Test]
    public void Radar_InEditMode_DoesNotTraceByItself()
    {
        var radar = new GameObject("Radar", typeof(Camera)).AddComponent<RadarController>();
        Steps(2);
        Assert.That(radar.Result, Is.Null);
        Assert.That(Log, Is.Empty);
    }

    // Fields, and the elements of arrays and lists, of the package's own types. What another component owns is a
    // reference to that component.
    static bool Owns(Type type, HashSet<Type> seen)
    {
        if (type == typeof(GraphicsBuffer) || type == typeof(ComputeBuffer))
            return true;
        if (type.HasElementType)
            return Owns(type.GetElementType(), seen);
        if (type.IsGenericType && type.GetGenericArguments().Any(argument => Owns(argument, seen)))
            return true;
        bool isOurs = type.Assembly == typeof(RadarController).Assembly;
        return isOurs && seen.Add(type) && type
            .GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic)
            .Any(field => !field.FieldType.IsSubclassOf(typeof(Object)) && Owns(field.FieldType, seen));
    }
}
