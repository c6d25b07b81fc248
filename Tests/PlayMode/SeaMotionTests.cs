using System.Collections;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Glint.Tests
{
    /// <summary>Seas that move in play mode.</summary>
    public sealed class SeaMotionTests
    {
        Sea _sea;

        [UnitySetUp]
        public IEnumerator LoadScene()
        {
            yield return PlayScene.Load("SeaState6");
            _sea = Object.FindFirstObjectByType<Sea>();
        }

        [UnityTest]
        public IEnumerator Waves_WhilePlaying_RunWithTheClock()
        {
            _sea.Snapshots.Clear();
            _sea.Motion = SeaMotion.Waves;
            double start = _sea.TimeSeconds, clock = Time.timeAsDouble;
            for (int frame = 0; frame < 3; frame++)
            {
                yield return null;
                var expected = new SeaSurface(_sea.Waves).Mesh(_sea.TimeSeconds);
                Assert.That(Shown().vertices.Select(v => (float3)v), Is.EqualTo(expected.Vertices));
            }
            Assert.That(_sea.TimeSeconds - start,
                Is.EqualTo(Time.timeAsDouble - clock).Within(1e-4).And.GreaterThan(0));
            Assert.That(_sea.GetComponentsInChildren<MeshFilter>().Select(tile => tile.sharedMesh).Distinct().Count(),
                Is.EqualTo(1), "both tiles show one mesh");
        }

        [UnityTest]
        public IEnumerator Snapshots_WhilePlaying_AreShownInTurnAndBeginAgain()
        {
            _sea.Motion = SeaMotion.Snapshots;
            _sea.SecondsPerSnapshot = 1e-3f; // shorter than a frame, so that only the clock selects it
            for (int frame = 0; frame < 5; frame++)
            {
                yield return null;
                int expected = 1 + (int)(Time.time / _sea.SecondsPerSnapshot) % 10;
                Assert.That(_sea.Snapshot, Is.EqualTo(expected));
                Assert.That(Shown(), Is.SameAs(_sea.Snapshots[expected - 1].Tile));
            }
        }

        Mesh Shown() => _sea.GetComponentInChildren<MeshFilter>().sharedMesh;
    }
}
