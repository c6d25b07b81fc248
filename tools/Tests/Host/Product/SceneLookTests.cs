using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Glint.Editor;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Host.Tests;

/// <summary>
/// Objects have a material of the render pipeline in use. Without one Unity draws them magenta or not at all.
/// </summary>
public sealed class SceneLookTests : EngineFixture
{
    static IEnumerable<Type> Components => typeof(RadarController).Assembly.GetTypes()
        .Where(type => type.GetCustomAttribute<AddComponentMenu>()?.componentMenu.Length > 0);

    [SetUp]
    public void OpenProject() => UseProject();

    [TearDown]
    public void LeavePipeline() => GraphicsSettings.defaultRenderPipeline = null;

    [Test]
    public void Components_OfTheMenu_AreTheseAtLeast() => Assert.That(Components,
        Is.SupersetOf(new[] { typeof(RadarController), typeof(RayPaths), typeof(Sea), typeof(Sweep) }));

    [TestCaseSource(nameof(Components))]
    public void Component_AddedInTheBuiltInPipeline_ShowsEveryMeshWithAMaterial(Type component) =>
        Assert.That(MaterialsBelow(component), Has.None.Null);

    [TestCaseSource(nameof(Components))]
    public void Component_AddedInAnotherPipeline_ShowsEveryMeshWithItsMaterial(Type component)
    {
        Material material = UsePipeline();
        Assert.That(MaterialsBelow(component), Has.All.EqualTo(material));
    }

    [Test]
    public void Sea_MadeByAScriptWhileAnotherPipelineDraws_HasItsMaterial()
    {
        Material material = UsePipeline();
        Engine.EnterPlayMode();
        new GameObject("Sea").AddComponent<Sea>();
        Assert.That(Materials(), Is.Not.Empty.And.All.EqualTo(material));
    }

    [Test]
    public void MenuObjects_InAnotherPipeline_HaveItsMaterial()
    {
        Material material = UsePipeline();
        SceneObjects.MakeCornerReflector(null);
        SceneObjects.MakeShip(null);
        SceneObjects.MakeSea(null);
        Assert.That(Materials().Length, Is.GreaterThan(4));
        Assert.That(Materials(), Has.All.EqualTo(material));
    }

    Material[] MaterialsBelow(Type component)
    {
        new GameObject("Object").AddComponent(component);
        Steps(1);
        Assert.That(Materials().Any(), Is.EqualTo(component == typeof(Sea)));
        return Materials();
    }

    static Material[] Materials() =>
        UnityEngine.Object.FindObjectsByType<MeshRenderer>(FindObjectsInactive.Exclude, FindObjectsSortMode.None)
            .Where(renderer => renderer.enabled).Select(renderer => renderer.sharedMaterial).ToArray();

    static Material UsePipeline()
    {
        var pipeline = ScriptableObject.CreateInstance<OtherPipeline>();
        GraphicsSettings.defaultRenderPipeline = pipeline;
        return pipeline.defaultMaterial;
    }

    sealed class OtherPipeline : RenderPipelineAsset
    {
        readonly Material _material = new((Shader)null) { name = "Lit", enableInstancing = true };

        public override Material defaultMaterial => _material;
    }
}
