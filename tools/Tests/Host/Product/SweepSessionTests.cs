using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Glint.Host.Tests;

/// <summary>Sweeps of the open scene, one pose a tick, as in the window.</summary>
public sealed class SweepSessionTests
{
    const string Corner = "Packages/com.glint.scenes/CornerReflector.unity";

    SweepForm _form;
    Quaternion _rotation;
    string _folder;

    [SetUp]
    public void OpenScene()
    {
        _folder = Directory.CreateTempSubdirectory("glint-session-").FullName;
        EditorSceneManager.OpenScene(Corner, OpenSceneMode.Single);
        _form = new SweepForm
        {
            Target = GameObject.Find("Corner Reflector").transform, [SweepAxis.Angle] = "0:30:10",
            Folder = Path.Combine(_folder, "session")
        };
        _form.FindRadar();
        SetSize();
        _rotation = _form.Target.localRotation;
    }

    [TearDown]
    public void Close()
    {
        EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
        Directory.Delete(_folder, true);
    }

    // Grazing angles and frequencies too; their changes are undone between poses.
    [Test]
    public void Session_OfAScene_WritesTheFilesOfTheCommand()
    {
        (_form[SweepAxis.Grazing], _form[SweepAxis.Frequency]) = ("5,10", "9e9:10e9:1e9");
        MoveAPart();
        var rows = Run(_form);
        Assert.That(rows.Count, Is.EqualTo(16));
        Assert.That(Batch.Execute(CommandLine.Parse(Commands.Sweep, new[]
        {
            Corner, "--target", "Corner Reflector", "--angles", "0:30:10", "--grazing", "5,10", "--frequency",
            "9e9:10e9:1e9", "--size", "96x54", "--out", Path.Combine(_folder, "command")
        }), new LogProgress()), Is.Zero);
        Assert.That(Timeless.Csv(_form.FolderPath), Is.EqualTo(Timeless.Csv(Path.Combine(_folder, "command"))));
        // Equal except for the recorded command, which has no --size in a session.
        Assert.That(WithoutCommand(_form.FolderPath), Is.EqualTo(WithoutCommand(Path.Combine(_folder, "command"))));
        Assert.That(StoredRun.Read(_form.FolderPath).Info.Command, Is.EqualTo(new[] { "sweep", "--angles=0:30:10",
            "--grazing=5,10", "--frequency=9e9:10e9:1e9", "--target=Corner Reflector", "--", Corner }));
    }

    // A scene is divided by the motion seen so far; earlier sweeps and traces must not affect the results.
    void MoveAPart()
    {
        var part = GameObject.Find("Plate X").transform;
        Run(new SweepForm
        {
            Radar = _form.Radar, Target = part, [SweepAxis.Angle] = "0,5", Folder = Path.Combine(_folder, "part")
        });
        var position = part.localPosition;
        _form.Radar.Trace();
        part.localPosition += Vector3.up;
        _form.Radar.Trace();
        part.localPosition = position;
    }

    [Test]
    public void Sea_ThatCannotBeShown_IsRefused()
    {
        var sea = new GameObject("Sea").AddComponent<Sea>();
        sea.Extent = Vector2.zero;
        Assert.That(() => SweepSession.Pose(_form.Radar),
            Throws.TypeOf<GlintException>().With.Message.Contains("Sea of 'Sea': its extent"));
    }

    [Test]
    public void Tick_TracesAPoseAndShowsItsRow()
    {
        using var session = SweepSession.Sweep(_form);
        Assert.That((session.Count, session.Done, session.IsRunning, session.SecondsLeft),
            Is.EqualTo((4, 0, true, (double?)null)));
        session.Tick();
        Assert.That((session.Done, session.Rows.Count, session.Rows[0][ResultColumn.RaysHit] > 0),
            Is.EqualTo((1, 1, true)));
        Assert.That(session.Status(), Does.StartWith("1 of 4 poses, "));
        session.Tick();
        Assert.That(Quaternion.Angle(_form.Target.localRotation, _rotation), Is.EqualTo(20).Within(0.01),
            "at the next pose, which the device traces meanwhile");
        while (session.IsRunning)
            session.Tick();
        Assert.That((session.Done, session.Problem, session.Status()), Is.EqualTo((4, (string)null, "4 of 4 poses")));
        AssertAsBefore();
        session.Tick();
        Assert.That(session.Rows.Count, Is.EqualTo(4), "a tick too many does nothing");
    }

    [Test]
    public void Tick_WithLooks_ShowsThePoseOfItsRow()
    {
        using var session = SweepSession.Sweep(_form);
        session.Tick();
        Assert.That(session.Preview, Is.Null);
        session.Looks = true;
        for (int row = 1; row < 3; row++)
        {
            session.Tick();
            Assert.That(session.Preview, Is.Not.Null);
            Assert.That(Quaternion.Angle(_form.Target.localRotation, _rotation), Is.EqualTo(10 * row).Within(0.01));
        }
    }

    [TestCase("cancel", "cancelled")]
    [TestCase("close the window", "cancelled")]
    [TestCase("reload scripts", "ended: scripts are reloaded")]
    [TestCase("save the scene", "ended: the scene is saved")]
    public void End_BetweenPoses_PutsEverythingBackAtOnceAndKeepsTheRows(string what, string problem)
    {
        var session = SweepSession.Sweep(_form);
        session.Tick();
        session.Tick();
        if (what == "cancel")
            session.Cancel();
        else if (what == "close the window")
            session.Dispose();
        else if (what == "reload scripts")
            AssemblyReloadEvents.Reload();
        else
            EditorSceneManager.RaiseSaving(SceneManager.GetActiveScene());
        Assert.That((session.IsRunning, session.Problem), Is.EqualTo((false, problem)));
        AssertAsBefore();
        Assert.That(File.ReadAllLines(Path.Combine(_form.FolderPath, "results.csv")).Length, Is.EqualTo(3));
        Assert.That(session.Status(), Does.Contain("2 of 4 poses").And.Contain("Resume"));
        Assert.That(StoredRun.RowsOf(_form.FolderPath).Select(row => row[ResultColumn.Amplitude]),
            Is.EqualTo(session.Rows.Select(row => row[ResultColumn.Amplitude])),
            "as a window finds them after a reload");
    }

    [Test]
    public void Cancel_WithinAPose_EndsItAndPutsEverythingBack()
    {
        var session = SweepSession.Sweep(_form);
        session.Tick();
        session.Tick(new Reports(_ => session.Cancel()));
        Assert.That((session.IsRunning, session.Done, session.Problem), Is.EqualTo((false, 1, "cancelled")));
        AssertAsBefore();
    }

    [Test]
    public void PlayMode_ThatBegins_EndsTheSession()
    {
        var session = SweepSession.Sweep(_form);
        session.Tick();
        Engine.EnterPlayMode();
        try
        {
            Assert.That((session.IsRunning, session.Problem), Is.EqualTo((false, "ended: play mode begins or ends")));
        }
        finally
        {
            Engine.ExitPlayMode();
        }
    }

    [Test]
    public void Scene_ThatIsClosed_EndsTheSession()
    {
        var session = SweepSession.Sweep(_form);
        session.Tick();
        EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
        Assert.That((session.IsRunning, session.Problem), Is.EqualTo((false, "ended: the scene is closed")));
    }

    [Test]
    public void Error_WithinAPose_EndsTheSessionInWords()
    {
        var session = SweepSession.Sweep(_form);
        session.Tick();
        Object.DestroyImmediate(_form.Radar.Receiver.gameObject);
        session.Tick();
        Assert.That((session.IsRunning, session.Done), Is.EqualTo((true, 2)), "the device had the second pose");
        session.Tick();
        Assert.That(session.IsRunning, Is.False);
        Assert.That(session.Problem, Does.StartWith("RadarController of 'Radar Camera' has no receiver"));
        AssertAsBefore();
        _form.Folder = Path.Combine(_folder, "other");
        Assert.Throws<GlintException>(() => SweepSession.Sweep(_form));
        Assert.That(Directory.Exists(_form.FolderPath), Is.False, "nothing is left of what could not begin");
    }

    [Test]
    public void Radar_ThatIsDestroyed_EndsTheSessionInWords()
    {
        var session = SweepSession.Sweep(_form);
        Object.DestroyImmediate(_form.Radar.gameObject);
        session.Tick();
        Assert.That(session.Problem, Does.StartWith("the radar of the sweep was destroyed"));
        AssertAsBefore();
    }

    [Test]
    public void Resume_OfAnEndedSession_GoesOnToTheSameFiles()
    {
        var session = SweepSession.Sweep(_form);
        session.Tick();
        session.Tick();
        session.Cancel();
        Assert.That((_form.FolderText(false), _form.FolderText(true)),
            Is.EqualTo((_form.FolderPath + " holds a sweep that is not finished: Resume continues it, "
                + "otherwise the first row replaces it.", _form.FolderPath)));
        _form.Resume = true;
        using (var resumed = SweepSession.Sweep(_form))
        {
            Assert.That((resumed.Done, resumed.Rows.Count), Is.EqualTo((2, 2)));
            while (resumed.IsRunning)
                resumed.Tick();
            Assert.That((resumed.Problem, resumed.Rows.Count), Is.EqualTo(((string)null, 4)));
        }
        Assert.That(_form.FolderText(false), Is.EqualTo(_form.FolderPath));
        string whole = Timeless.Csv(_form.FolderPath);
        using (var again = SweepSession.Sweep(_form))
            Assert.That((again.IsRunning, again.Rows.Count, again.Problem),
                Is.EqualTo((false, 4, (string)null)), "already complete");
        _form.Folder = Path.Combine(_folder, "whole");
        Run(_form);
        Assert.That(Timeless.Csv(_form.FolderPath), Is.EqualTo(whole));
    }

    [Test]
    public void Pose_OfARadar_IsWhatItTraces()
    {
        using var session = SweepSession.Pose(_form.Radar);
        session.Tick();
        Assert.That((session.IsRunning, session.Problem, session.Rows.Count), Is.EqualTo((false, (string)null, 1)));
        Assert.That(session.Rows[0][ResultColumn.Amplitude], Is.EqualTo(_form.Radar.Trace().Amplitude));
        Assert.That(session.Rows[0].PhaseHistogram.Sum(), Is.EqualTo(session.Rows[0][ResultColumn.RaysReceived]));
    }

    [Test]
    public void Session_InPlayMode_SweepsAsInEditMode()
    {
        var rows = Run(_form);
        Engine.EnterPlayMode();
        try
        {
            FillAgain();
            foreach (var sweep in Object.FindObjectsByType<Sweep>(FindObjectsInactive.Include,
                FindObjectsSortMode.None))
                Object.DestroyImmediate(sweep);
            Assert.That(Run(_form).Select(row => row[ResultColumn.Amplitude]),
                Is.EqualTo(rows.Select(row => row[ResultColumn.Amplitude])));
        }
        finally
        {
            Engine.ExitPlayMode();
        }
    }

    [Test]
    public void Session_WhileASweepComponentIsAtWork_IsRefused()
    {
        Engine.EnterPlayMode();
        try
        {
            FillAgain();
            Object.FindFirstObjectByType<Sweep>().OutputFolder = Path.Combine(_folder, "component");
            Engine.Step();
            Assert.That(() => SweepSession.Sweep(_form),
                Throws.TypeOf<GlintException>().With.Message.Contains("'Sweep' is sweeping this scene"));
        }
        finally
        {
            Engine.ExitPlayMode();
        }
    }

    // Play mode has reloaded the scene, and no script has started yet.
    void FillAgain()
    {
        (_form.Target, _form.Radar) = (GameObject.Find("Corner Reflector").transform, null);
        _form.FindRadar();
        SetSize();
    }

    void SetSize()
    {
        var settings = _form.Radar.Settings;
        (settings.RaysAcross, settings.RaysDown) = (96, 54);
        _form.Radar.Settings = settings;
    }

    [TestCase("0:45", "--angles 0:45: a range has three parts")]
    [TestCase("1,x", "--angles 1,x: x is not a number")]
    [TestCase("400", "--angles 400: each angle must be from -360 to 360 degrees")]
    [TestCase("", null)]
    [TestCase("0:45:1", null)]
    public void Form_SaysWhatTheCommandWouldSay(string angles, string problem)
    {
        _form[SweepAxis.Angle] = angles;
        string said = _form.ProblemOf(SweepAxis.Angle);
        if (problem == null)
            Assert.That(said, Is.Null);
        else
            Assert.That(said, Does.StartWith(problem));
    }

    [Test]
    public void Form_ThatIsNotFit_SaysWhatIsMissing()
    {
        Assert.That(_form.Problem(), Is.Null);
        _form.Target = null;
        Assert.That(_form.Problem(), Does.Contain("--target is missing"));
        _form[SweepAxis.Angle] = " ";
        Assert.That(_form.Problem(), Does.Contain("nothing to step through"));
        _form[SweepAxis.Frequency] = "9e9,10e9";
        Assert.That(_form.Problem(), Is.Null, "nothing is turned");
        _form[SweepAxis.Snapshot] = "1:3";
        Assert.That(() => SweepSession.Sweep(_form),
            Throws.TypeOf<GlintException>().With.Message.Contains("has no Sea component"));
        _form.Radar.enabled = false;
        Assert.That(_form.Problem(), Does.Contain("is disabled"));
        _form.Radar = null;
        Assert.That(_form.Problem(), Does.StartWith("no radar"));
    }

    [Test]
    public void Folder_OfAForm_IsTheCommandsUnlessGiven()
    {
        string project = Path.GetDirectoryName(Application.dataPath);
        _form.Folder = "";
        Assert.That(_form.FolderPath, Is.EqualTo(Path.Combine(project, "Results", "CornerReflector")));
        _form.Folder = " out/a ";
        Assert.That(_form.FolderPath, Is.EqualTo(Path.Combine(project, "out/a")));
    }

    void AssertAsBefore()
    {
        Assert.That(_form.Target.localRotation, Is.EqualTo(_rotation));
        Assert.That(SceneManager.GetActiveScene().isDirty, Is.False);
    }

    static IReadOnlyList<StoredRow> Run(SweepForm form)
    {
        using var session = SweepSession.Sweep(form);
        while (session.IsRunning)
            session.Tick();
        Assert.That(session.Problem, Is.Null);
        return session.Rows;
    }

    static string WithoutCommand(string folder) =>
        System.Text.RegularExpressions.Regex.Replace(Timeless.Json(folder), "\"command\": \\[[^\\]]*\\]", "");

    sealed class Reports : IProgress<double>
    {
        readonly Action<double> _act;

        public Reports(Action<double> act) => _act = act;

        public void Report(double value) => _act(value);
    }
}
