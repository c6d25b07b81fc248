using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Glint.Tests
{
    /// <summary>Scenes/CornerReflector.unity against the published table and the recovered one.</summary>
    [Category("Slow")]
    public sealed class CornerReflectorTests
    {
        RadarController _radar;
        Transform _target;

        [UnitySetUp]
        public IEnumerator LoadScene()
        {
            yield return PlayScene.Load("CornerReflector");
            _radar = Object.FindFirstObjectByType<RadarController>();
            _target = GameObject.Find("Corner Reflector").transform;
        }

        [Test]
        public void Scene_OnLoad_HasTracedOnePoseByItself()
        {
            Assert.That(_radar.Result, Is.Not.Null);
            Assert.That(_radar.Result.RaysEmitted, Is.EqualTo(2073600));
            Assert.That(_radar.Result.Statistics.Triangles, Is.EqualTo(36), "three cubes");
            Assert.That(_radar.Result.RaysReceived, Is.EqualTo(676), "26 x 26 at 0 to 4 deg");
        }

        [Test]
        public void Scene_ItsGeometry_IsTheRecoveredOne()
        {
            // The vertex of the inner faces, relative to the pivot (7.871, 7.871, 8.052) m along axes tilted by 49.132
            // degrees.
            double lean = math.radians(49.132);
            var vertex = new Vector3(0, (float)(math.sqrt(2.0) * 7.871 * math.sin(lean) - 8.052 * math.cos(lean)),
                (float)(math.sqrt(2.0) * 7.871 * math.cos(lean) + 8.052 * math.sin(lean)));
            var plates = _target.GetComponentsInChildren<MeshFilter>().Select(filter => filter.transform).ToArray();
            Assert.That(plates.Length, Is.EqualTo(3));
            foreach (var plate in plates)
            {
                var scale = plate.lossyScale;
                Assert.That(scale.x * scale.y * scale.z,
                    Is.EqualTo(16.004f * 16.004f * 0.211f).Within(1e-3f), plate.name);
                Assert.That(Vector3.Distance(plate.parent.position, vertex), Is.LessThan(1e-5f), "vertex");
            }
            var (radar, receiver) = (_radar.transform, _radar.Receiver);
            Assert.That(radar.position.magnitude, Is.EqualTo(41.112f).Within(1e-4f));
            Assert.That(Pitch(radar), Is.EqualTo(9.985f).Within(1e-4f));
            Assert.That(Pitch(receiver), Is.EqualTo(9.985f - 4).Within(1e-4f));
            Assert.That(
                Vector3.Distance(receiver.position, radar.position - 0.236f * radar.forward - 0.210f * radar.up),
                Is.LessThan(1e-5f));
        }

        // Degrees below the horizontal.
        static float Pitch(Transform turned) => Mathf.Asin(-turned.forward.y) * Mathf.Rad2Deg;

        [Test]
        [Timeout(600000)]
        public void Sweep_AllAngles_AgreesWithTheRecoveredAndWithThePublishedTable()
        {
            var recovered = ReferenceTable.Load("corner_reflector_recovered");
            var published = ReferenceTable.Load("table_a2_corner_reflector");
            Assert.That(recovered.Count, Is.EqualTo(46));
            PlayScene.SkipSamplingError(_radar);
            var (hitPercent, received, decibels) = (new List<double>(), new List<double>(), new List<double>());
            var amplitudes = new List<double2>();
            for (int row = 0; row < recovered.Count; row++)
            {
                _target.rotation = Quaternion.AngleAxis((float)recovered.Angle(row), Vector3.up);
                var result = _radar.Trace();
                string at = $"{recovered.Angle(row)} deg";
                Assert.That(result.RaysHit, Is.EqualTo(recovered.Hit(row)).Within(0.02).Percent, $"hits at {at}");
                Assert.That(result.RaysReceived, Is.EqualTo(recovered.Received(row)).Within(3), $"received at {at}");
                double moreOrFewer = System.Math.Abs(result.RaysReceived - recovered.Received(row));
                Assert.That(result.Amplitude,
                    Is.EqualTo(recovered.Amplitude(row)).Within(0.005 * recovered.Amplitude(row) + 0.1 + moreOrFewer),
                    $"amplitude at {at}");

                hitPercent.Add(100 * System.Math.Abs(result.RaysHit / (double)published.Hit(row) - 1));
                received.Add(System.Math.Abs(result.RaysReceived - published.Received(row)));
                amplitudes.Add(new double2(result.Amplitude, published.Amplitude(row)));
                if (published.Amplitude(row) > 0.5)
                    decibels.Add(System.Math.Abs(20 * System.Math.Log10(result.Amplitude / published.Amplitude(row))));
                Assert.That(hitPercent[row], Is.LessThan(0.03), $"published hits at {at}, percent");
                Assert.That(received[row], Is.LessThanOrEqualTo(48), $"published rays received at {at}");
            }
            Assert.That(hitPercent.Average(), Is.LessThan(0.006), "published hits, mean percent");
            Assert.That(received.Average(), Is.LessThan(13.5), "published rays received, mean");
            Assert.That(decibels.Count, Is.EqualTo(41), "0 to 40 deg; at 41 deg two rays are published, none is ours");
            Assert.That(decibels.OrderBy(size => size).ElementAt(decibels.Count / 2), Is.LessThan(1.7),
                "published amplitudes, median dB");
            Assert.That(Correlation(amplitudes), Is.GreaterThan(0.97), "published amplitudes");
        }

        static double Correlation(IReadOnlyList<double2> pairs)
        {
            var mean = new double2(pairs.Average(pair => pair.x), pairs.Average(pair => pair.y));
            double Product(System.Func<double2, double> product) => pairs.Sum(pair => product(pair - mean));
            return Product(d => d.x * d.y) / System.Math.Sqrt(Product(d => d.x * d.x) * Product(d => d.y * d.y));
        }

        // Rounding of the rotated coordinates changes the paths of hundreds of rays by thousandths of a wavelength.
        [TestCase(0, 37, 0)]
        [TestCase(20, 77, -35)]
        [TestCase(-80, 190, 123)]
        public void Trace_RadarAndTargetTurnedTogether_HasTheAmplitudeOfBefore(float x, float y, float z)
        {
            PlayScene.SkipSamplingError(_radar);
            var before = _radar.Trace();
            var root = new GameObject("Root").transform;
            _radar.transform.SetParent(root, true);
            _target.SetParent(root, true);
            root.localRotation = Quaternion.Euler(x, y, z);
            _radar.transform.SetParent(null, true);
            _target.SetParent(null, true);
            Object.Destroy(root.gameObject);
            Assert.That(_radar.Trace().Amplitude, Is.EqualTo(before.Amplitude).Within(0.02 * before.Amplitude + 0.5));
        }

        [Test]
        public void Trace_Twice_SumsAreTheSameBitForBit()
        {
            var first = _radar.Trace();
            var again = _radar.Trace();
            Assert.That(again.InPhase, Is.EqualTo(first.InPhase));
            Assert.That(again.Quadrature, Is.EqualTo(first.Quadrature));
            Assert.That(again.PathLengthMeters, Is.EqualTo(first.PathLengthMeters));
        }

        [Test]
        public void PhaseHistogram_AtZeroAndAt23Degrees_IsUnevenAndFlat()
        {
            // Returns add up at 0 deg and cancel at 23 deg; the thesis shows both histograms.
            PlayScene.SkipSamplingError(_radar);
            var atZero = _radar.Trace().PhaseHistogram;
            _target.rotation = Quaternion.AngleAxis(23, Vector3.up);
            var at23 = _radar.Trace().PhaseHistogram;
            Assert.That(atZero.Sum(), Is.EqualTo(676));
            Assert.That(Spread(atZero), Is.GreaterThan(Spread(at23)));
        }

        // Largest bin over the mean bin.
        static double Spread(IReadOnlyList<long> histogram) => histogram.Max() / histogram.Average();
    }
}
