using System.Linq;
using Glint.Editor;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>The inspectors' text about Ray Paths, and the button that adds them.</summary>
    public sealed class RayPathsFiguresTests : InspectorFixture
    {
        [Test]
        public void ShowRayPaths_AddsThemAndUndoRemovesThem()
        {
            Undo.ClearAll();
            RadarFixes.ShowRayPaths(_radar).Apply();
            Assert.That(_radar.GetComponent<RayPaths>() != null);
            Undo.PerformUndo();
            Assert.That(_radar.GetComponent<RayPaths>() == null);
        }

        [Test]
        public void Rows_SayHowManyAreDrawnAndHowManyWereFollowed()
        {
            var paths = Show(640, 360);
            Assert.That(RayPathsFigures.Check(paths), Is.Null);
            Assert.That(RayPathsFigures.Rows(paths).Single().value, Is.EqualTo($"{_radar.Result.RaysReceived:N0}"));
            paths.ReceivedOnly = false;
            paths.Lines();
            Assert.That(RayPathsFigures.Rows(paths).Single().value,
                Is.EqualTo($"{paths.Count:N0}; followed 100,000 of 230,400"));
        }

        [Test]
        public void Check_SaysWhyNoneAreDrawn()
        {
            var paths = _radar.gameObject.AddComponent<RayPaths>();
            Assert.That(RayPathsFigures.Check(paths).Text, Does.Contain("nothing is traced yet"));
            _radar.Trace();
            paths.Lines();
            Assert.That(RayPathsFigures.Check(paths), Is.Null);
            (paths.MinBounces, paths.MaxBounces) = (3, 2);
            paths.Lines();
            Assert.That(paths.Count, Is.Zero);
            Assert.That(RayPathsFigures.Check(paths).Text, Does.Contain("none has 3 bounces or more and 2 or fewer"));
            (paths.MinBounces, paths.MaxBounces) = (1, 2);
            _plate.transform.position += Vector3.forward;
            paths.Every = 2;
            paths.Lines();
            Assert.That(RayPathsFigures.Check(paths).Text, Does.Contain("has changed since the last pose"));
        }

        RayPaths Show(int across, int down)
        {
            _radar.Settings = TestRadar.Settings(across, down);
            var paths = _radar.gameObject.AddComponent<RayPaths>();
            _radar.Trace();
            paths.Lines();
            return paths;
        }
    }
}
