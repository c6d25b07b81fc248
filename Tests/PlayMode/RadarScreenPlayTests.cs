using System;
using System.Collections;
using System.Net;
using System.Net.Sockets;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Glint.Tests
{
    /// <summary>The scene Harbour Approach in play mode, with fewer spokes and cells.</summary>
    [Category("Slow")]
    public sealed class RadarScreenPlayTests
    {
        // The scene stays, and its frames take long.
        [TearDown]
        public void StopScreens()
        {
            foreach (var screen in Object.FindObjectsByType<RadarScreen>(FindObjectsInactive.Exclude, FindObjectsSortMode.None))
                screen.enabled = false;
        }

        [UnityTest]
        [Timeout(600000)]
        public IEnumerator Screen_WhilePlaying_TurnsWithTheClock_AndShipsMove()
        {
            yield return PlayScene.Load("HarbourApproach", () => MakeSmall(Object.FindFirstObjectByType<RadarScreen>()));
            var screen = Object.FindFirstObjectByType<RadarScreen>();
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

        // A category, a length and the spokes in their order: 360 / 1024 degrees are 64 units.
        [UnityTest]
        public IEnumerator VideoSender_SendsEachSpoke_ToThisMachine()
        {
            var made = new GameObject("Radar");
            made.SetActive(false);
            var screen = made.AddComponent<RadarScreen>();
            screen.Kernel = PlayAsset.Load<ComputeShader>("Packages/com.glint.radar/Shaders/Screen.compute");
            MakeSmall(screen);
            using (var receiver = new UdpClient(new IPEndPoint(IPAddress.Loopback, 0)))
            {
                var sender = made.AddComponent<RadarVideoSender>();
                sender.Port = ((IPEndPoint)receiver.Client.LocalEndPoint).Port;
                made.SetActive(true);
                for (int frame = 0; frame < 600 && receiver.Available == 0; frame++)
                    yield return null;
                for (int frame = 0; frame < 5; frame++)
                    yield return null;
                IPEndPoint from = null;
                int azimuth = -1, count = 0;
                for (; receiver.Available > 0 && count < 20; count++)
                {
                    byte[] message = receiver.Receive(ref from);
                    Assert.That((message[0], message[1] << 8 | message[2]), Is.EqualTo((240, message.Length)));
                    int start = message[12] << 8 | message[13];
                    if (azimuth >= 0)
                        Assert.That(start, Is.EqualTo((azimuth + 64) & 0xFFFF), "the next spoke");
                    azimuth = start;
                }
                Assert.That(count, Is.GreaterThan(1));
            }
            Object.Destroy(made);
            yield return null;
        }

        static void MakeSmall(RadarScreen screen)
        {
            var radar = screen.Radar;
            (radar.Spokes, radar.Cells) = (1024, 100);
            var display = screen.Display;
            display.Side = 64;
            (screen.Radar, screen.Display) = (radar, display);
        }
    }
}
