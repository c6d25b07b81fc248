using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Glint.Host.Tests;

public sealed class SceneTests : EngineFixture
{
    const string One = "Assets/One.unity";
    const string Two = "Packages/com.glint.scenes/Two.unity";

    readonly List<string> _events = new();

    [SetUp]
    public void OpenProject()
    {
        var project = new FakeProject();
        project.Scenes[One] = scene => FakeProject.Put<Talker>(scene, "one");
        project.Scenes[Two] = scene => FakeProject.Put<Talker>(scene, "two");
        Engine.Assets = project;
        _events.Clear();
        SceneManager.sceneLoaded += Loaded;
        SceneManager.sceneUnloaded += Unloaded;
    }

    [TearDown]
    public void Unsubscribe()
    {
        SceneManager.sceneLoaded -= Loaded;
        SceneManager.sceneUnloaded -= Unloaded;
    }

    [Test]
    public void LoadScene_Single_ReplacesTheSceneInTheNextFrame()
    {
        Play();
        var old = new GameObject("old");
        SceneManager.LoadScene(One);
        Assert.That(old != null && SceneManager.GetActiveScene().path != One);
        Steps(1);
        Assert.That(old == null);
        Assert.That(SceneManager.sceneCount, Is.EqualTo(1));
        Assert.That(SceneManager.GetActiveScene().path, Is.EqualTo(One));
        Assert.That(SceneManager.GetActiveScene().name, Is.EqualTo("One"));
        Assert.That(SceneManager.GetActiveScene().GetRootGameObjects().Single().name, Is.EqualTo("one"));
        Assert.That(_events, Is.EqualTo(new[] { "unloaded ", "loaded One Single" }));
    }

    [Test]
    public void LoadScene_Messages_AwakeBeforeSceneLoadedBeforeStart()
    {
        Play();
        SceneManager.sceneLoaded += Note;
        EditorSceneManager.LoadSceneInPlayMode(One, new LoadSceneParameters(LoadSceneMode.Single));
        Steps(1);
        SceneManager.sceneLoaded -= Note;
        Assert.That(
            Diary.Text,
            Is.EqualTo("one.OnValidate one.Awake one.OnEnable sceneLoaded one.Start one.Update one.LateUpdate"));

        static void Note(Scene scene, LoadSceneMode mode) => Diary.Entries.Add("sceneLoaded");
    }

    [Test]
    public void LoadSceneAsync_Additive_KeepsTheOtherScene()
    {
        Play();
        SceneManager.LoadScene(One);
        Steps(1);
        AsyncOperation operation =
            EditorSceneManager.LoadSceneAsyncInPlayMode(Two, new LoadSceneParameters(LoadSceneMode.Additive));
        bool called = false;
        operation.completed += _ => called = true;
        Assert.That(operation.isDone, Is.False);
        Steps(1);
        Assert.That(operation.isDone && called);
        Assert.That(SceneManager.sceneCount, Is.EqualTo(2));
        Assert.That(SceneManager.GetActiveScene().path, Is.EqualTo(One));
        Assert.That(SceneManager.GetSceneByName("Two").isLoaded);
        Assert.That(SceneManager.GetSceneAt(1), Is.EqualTo(SceneManager.GetSceneByPath(Two)));

        Assert.That(SceneManager.SetActiveScene(SceneManager.GetSceneByPath(Two)));
        Assert.That(new GameObject("here").scene.path, Is.EqualTo(Two));
        SceneManager.UnloadSceneAsync(Two);
        Steps(1);
        Assert.That(SceneManager.GetActiveScene().path, Is.EqualTo(One));
        Assert.That(GameObject.Find("here"), Is.Null);
    }

    [Test]
    public void LoadSceneAsync_ActivationHeldBack_WaitsForIt()
    {
        Play();
        AsyncOperation operation = SceneManager.LoadSceneAsync(One);
        operation.allowSceneActivation = false;
        Steps(3);
        Assert.That(operation.isDone, Is.False);
        Assert.That(operation.progress, Is.EqualTo(0.9f));
        operation.allowSceneActivation = true;
        Steps(1);
        Assert.That(SceneManager.GetActiveScene().path, Is.EqualTo(One));
    }

    [Test]
    public void LoadScene_Unknown_LogsAnErrorThatNamesIt()
    {
        Play();
        Assert.That(SceneManager.LoadSceneAsync("Nowhere"), Is.Null);
        Assert.That(Errors[0], Does.StartWith("Scene 'Nowhere' couldn't be loaded"));
    }

    [Test]
    public void LoadScene_InEditMode_IsRefused()
    {
        Assert.Throws<InvalidOperationException>(() => SceneManager.LoadScene(One));
    }

    [Test]
    public void LoadScene_FailingFile_LeavesAnEmptySceneAndTheReason()
    {
        ((FakeProject)Engine.Assets).Scenes[One] = _ => throw new FormatException("line 3 is no YAML");
        Play();
        SceneManager.LoadScene(One);
        Steps(1);
        Assert.That(Errors[0], Does.Contain("line 3 is no YAML"));
        Assert.That(SceneManager.sceneCount, Is.EqualTo(1));
        Assert.That(SceneManager.GetActiveScene().isLoaded);
    }

    [Test]
    public void DontDestroyOnLoad_SurvivesASceneChange()
    {
        Play();
        var item = new GameObject("kept");
        Object.DontDestroyOnLoad(item);
        SceneManager.LoadScene(One);
        Steps(1);
        Assert.That(item != null);
        Assert.That(item.scene.name, Is.EqualTo("DontDestroyOnLoad"));
        Assert.That(GameObject.Find("kept"), Is.SameAs(item));
        Engine.ExitPlayMode();
        Assert.That(item == null);
    }

    [Test]
    public void CreateScene_TakesMovedObjects()
    {
        Play();
        Scene scene = SceneManager.CreateScene("made");
        var item = new GameObject("a");
        var child = new GameObject("b");
        child.transform.SetParent(item.transform);
        SceneManager.MoveGameObjectToScene(item, scene);
        Assert.That(child.scene, Is.EqualTo(scene));
        Assert.That(scene.rootCount, Is.EqualTo(1));
        Assert.Throws<ArgumentException>(() => SceneManager.MoveGameObjectToScene(child, scene));
        Assert.Throws<ArgumentException>(() => SceneManager.CreateScene("made"));
    }

    [Test]
    public void OpenScene_InEditMode_ClosesTheOtherAndStaysSilent()
    {
        var closed = new List<string>();
        EditorSceneManager.SceneClosingCallback note = (scene, removing) => closed.Add($"{scene.name} {removing}");
        EditorSceneManager.OpenScene(One);
        EditorSceneManager.sceneClosing += note;
        Scene two = EditorSceneManager.OpenScene(Two);
        EditorSceneManager.sceneClosing -= note;
        Assert.That(closed, Is.EqualTo(new[] { "One True" }));
        Assert.That(two.isLoaded && two == SceneManager.GetActiveScene());
        Assert.That(Diary.Text, Is.EqualTo("one.OnValidate two.OnValidate"));
        Assert.That(_events, Is.Empty);
    }

    [Test]
    public void OpenScene_Missing_IsRefusedByName()
    {
        var error = Assert.Throws<ArgumentException>(() => EditorSceneManager.OpenScene("Assets/No.unity"));
        Assert.That(error.Message, Does.Contain("Assets/No.unity"));
    }

    [Test]
    public void OpenScene_FailingFile_ThrowsAndLeavesAnEmptyScene()
    {
        ((FakeProject)Engine.Assets).Scenes[One] = scene =>
        {
            FakeProject.Put<Talker>(scene, "half");
            throw new FormatException("cut off");
        };
        Assert.Throws<FormatException>(() => EditorSceneManager.OpenScene(One));
        Assert.That(SceneManager.GetActiveScene().path, Is.Empty);
        Assert.That(SceneManager.sceneCount, Is.EqualTo(1));
        Assert.That(GameObject.Find("half"), Is.Null);
    }

    [Test]
    public void NewScene_IsEmptyOrHasACamera()
    {
        new GameObject("old");
        Scene empty = EditorSceneManager.NewScene(NewSceneSetup.EmptyScene);
        Assert.That(empty.rootCount, Is.Zero);
        Assert.That(SceneManager.sceneCount, Is.EqualTo(1));
        EditorSceneManager.NewScene(NewSceneSetup.DefaultGameObjects, NewSceneMode.Additive);
        Assert.That(Camera.main.transform.position, Is.EqualTo(new Vector3(0f, 1f, -10f)));
    }

    [Test]
    public void PlayMode_ReloadsTheOpenSceneAndRestoresItAfterwards()
    {
        EditorSceneManager.OpenScene(One);
        GameObject.Find("one").name = "renamed";
        Diary.Clear();
        Play();
        Assert.That(Diary.Text, Is.EqualTo("one.OnValidate one.Awake one.OnEnable"));
        new GameObject("made in play mode");
        Engine.ExitPlayMode();
        Assert.That(SceneManager.GetActiveScene().path, Is.EqualTo(One));
        Assert.That(SceneManager.GetActiveScene().GetRootGameObjects().Single().name, Is.EqualTo("one"));
    }

    [Test]
    public void Prefab_Asset_IsInNoSceneAndAsleepUntilInstantiated()
    {
        Play();
        GameObject prefab = FakeProject.Put<Talker>(default, "prefab").gameObject;
        ObjectFactory.Awaken(new[] { prefab });
        Assert.That(prefab.scene.IsValid(), Is.False);
        Assert.That(prefab.activeSelf && !prefab.activeInHierarchy);
        Assert.That(Object.FindObjectsByType<Talker>(FindObjectsInactive.Include, FindObjectsSortMode.None), Is.Empty);
        Assert.That(Diary.Text, Is.EqualTo("prefab.OnValidate"));
        GameObject clone = Object.Instantiate(prefab);
        Assert.That(clone.activeInHierarchy && clone.scene == SceneManager.GetActiveScene());
        Assert.That(Diary.Entries, Has.Member("prefab(Clone).Awake"));
    }

    [Test]
    public void InstanceIds_OfFileAndRuntimeObjects_DifferInSign()
    {
        EditorSceneManager.OpenScene(One);
        Assert.That(GameObject.Find("one").GetInstanceID(), Is.Positive);
        Assert.That(new GameObject("a").GetInstanceID(), Is.Negative);
    }

    void Loaded(Scene scene, LoadSceneMode mode) => _events.Add($"loaded {scene.name} {mode}");

    void Unloaded(Scene scene) => _events.Add($"unloaded {scene.name}");
}
