using System;
using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Glint.Tests
{
    /// <summary>The scene Harbour Approach in play mode, with fewer spokes and cells.</summary>
    public sealed class RadarScreenPlayTests
    {
        [UnityTest]
        public IEnumerator Screen_WhilePlaying_TurnsWithTheClock_AndShipsMove()
        {
            yield return PlayScene.Load("HarbourApproach");
            var screen = Object.FindFirstObjectByType<RadarScreen>();
            var radar = screen.Radar;
            (radar.Spokes, radar.Cells) = (1024, 100);
            var display = screen.Display;
            display.Side = 64;
            (screen.Radar, screen.Display) = (radar, display);
            yield return null;
            var picture = screen.Picture;
            double bearing = screen.AntennaDegrees, clock = Time.timeAsDouble;
            var ship = screen.OwnShip.position;
            for (int frame = 0; frame < 5; frame++)
                yield return null;
            double seconds = Time.timeAsDouble - clock;
            Assert.That(Math.IEEERemainder(screen.AntennaDegrees - bearing - 144 * seconds, 360),
                Is.EqualTo(0).Within(0.01), "24 turns a minute");
            // 12 knots.
            Assert.That((screen.OwnShip.position - ship).magnitude, Is.EqualTo(6.173 * seconds).Within(0.01));
            Assert.That(screen.HeadingDegrees, Is.EqualTo(20).Within(0.01));
            Assert.That(screen.Picture, Is.SameAs(picture).And.Not.Null);
        }
    }
}
