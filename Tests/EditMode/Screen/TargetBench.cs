using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Meshes around the antenna of a radar screen, and their fields before beam and pulse.</summary>
    sealed class TargetBench : IDisposable
    {
        /// <summary>Of the antenna above the sea, metres.</summary>
        public const double Height = 50;

        /// <summary>Turns whose mean is compared, each with other phases of the points.</summary>
        public const int Seeds = 40;

        public static readonly double3 Antenna = new double3(0, Height, 0);

        readonly ScreenRadar _radar;
        readonly RadarScene _scene;
        readonly ScreenTargets _targets;

        public TargetBench(RadarScene scene, params bool[] isOwnShip)
            : this(scene, Radar, isOwnShip)
        {
        }

        public TargetBench(RadarScene scene, in ScreenRadar radar, params bool[] isOwnShip)
        {
            (_scene, _radar) = (scene, radar);
            Geometry = new ScreenGeometry(radar, "test");
            _targets = new ScreenTargets("test", Geometry);
            _targets.SetScene(scene, isOwnShip);
        }

        public ScreenGeometry Geometry { get; }

        /// <summary>2,048 spokes, cells of 10 m, and a beam that is as high as can be.</summary>
        public static ScreenRadar Radar
        {
            get
            {
                var radar = ScreenBench.Small(2048, 64);
                (radar.RangeScale, radar.VerticalBeamWidth) = (640, 179);
                return radar;
            }
        }

        public void MoveTo(RadarScene scene)
        {
            scene.Instances.CopyTo(_scene.Instances, 0);
            _targets.Move();
        }

        /// <summary>Fields of a turn in frames of some degrees, spoke by spoke, in units.</summary>
        public int[] Turn(int seed, double step)
        {
            var radar = _radar;
            radar.Seed = seed;
            using (var tracer = new ScreenTracer(TestKernels.Screen, "test", radar))
            {
                // The beam's leading edge comes to the first spokes again, and they are cleared before.
                for (double at = 0; at < 360 + step; at += step)
                {
                    tracer.Begin(at / 360);
                    tracer.AddTargets(_targets, Antenna, 0, 0);
                }
                var fields = new int[2 * radar.Spokes * radar.Cells];
                tracer.Echo.ReadBack(fields, fields.Length);
                return fields;
            }
        }

        /// <summary>Mean power of each spoke and cell over some turns, as sections over R^4.</summary>
        public double[] Power(int seeds)
        {
            var power = new double[_radar.Spokes * _radar.Cells];
            double unit = 1 / (Geometry.AmplitudeAtOne * Geometry.AmplitudeAtOne * seeds);
            for (int seed = 0; seed < seeds; seed++)
            {
                int[] fields = Turn(seed, 170);
                for (int i = 0; i < power.Length; i++)
                    power[i] += ((double)fields[2 * i] * fields[2 * i] + (double)fields[2 * i + 1] * fields[2 * i + 1]) * unit;
            }
            return power;
        }

        /// <summary>Four deviations of the sum over cells of exponential numbers, dB.</summary>
        public double Tolerance(double[] power) => 10 * Math.Log10(1 + 4 * Math.Sqrt(power.Sum(cell => cell * cell) / Seeds)
            / power.Sum());

        /// <summary>Compares the mean with a sum of sections over R^4.</summary>
        /// <param name="more">Besides the deviation of the mean, dB.</param>
        public void AssertMean(double expected, double more)
        {
            double[] power = Power(Seeds);
            double decibels = 10 * Math.Log10(power.Sum() / expected);
            TestContext.WriteLine($"{decibels:F2} dB, tolerance {Tolerance(power):F2} and {more} dB");
            Assert.That(decibels, Is.EqualTo(0).Within(Tolerance(power) + more));
        }

        public void Dispose() => _targets.Dispose();
    }
}
