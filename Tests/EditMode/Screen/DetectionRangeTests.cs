using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>
    /// IMO resolution MSC.192(79), table 2: ranges at which targets are seen in eight of ten scans at a false-alarm rate
    /// of 1e-4, X band, antenna at 15 m. Cross sections of buoys and small vessels are those of its footnotes and of
    /// MSC.164(78). The resolution gives none for ships and shores: <see cref="Ship"/> and <see cref="Shore"/> do. Targets
    /// are points at the stated height.
    /// </summary>
    public sealed class DetectionRangeTests
    {
        const double AntennaHeight = 15, Rate = 1e-4;
        const double Wavelength = 299792458 / 9.41e9;
        const int Scans = 10, Needed = 8;

        static readonly (string name, double height, double miles, double section)[] s_targets =
        {
            ("shore of 60 m", 60, 20, Shore(60, 20)), ("shore of 6 m", 6, 8, Shore(6, 8)),
            ("shore of 3 m", 3, 6, Shore(3, 6)), ("ship above 5,000 tons", 10, 11, Ship(5)),
            ("ship above 500 tons", 5, 8, Ship(0.5)),
            ("small vessel with reflector", 4, 5, 7.5), ("buoy with corner reflector", 3.5, 4.9, 10),
            ("typical buoy", 3.5, 4.6, 5), ("10 m vessel without reflector", 2, 3.4, 2.5)
        };

        // The noise alone passes the threshold at the stated rate, by ScreenTracerTests. No target of the table is in a
        // null of the smooth sea either: the detours are 0.12 to 0.30 wavelengths.
        [TestCase(0)]
        [TestCase(1)]
        public void Targets_AreSeenAtTheirRanges(double reflection)
        {
            int[] seen = Seen(reflection, s_targets);
            for (int i = 0; i < seen.Length; i++)
            {
                var (name, height, miles, _) = s_targets[i];
                double waves = SeaFactor.Detour(AntennaHeight, height, miles * 1852) / Wavelength;
                string text = FormattableString.Invariant($"{name}: {s_targets[i].section:0.#} m2, {Level(i):0.0} dB over noise")
                    + (reflection == 0 ? "" : FormattableString.Invariant(
                        $", detour {waves:0.00} wavelengths, {Factor(waves):0.0} dB by the sea, {NullOf(waves)}"))
                    + $": {seen[i]} of {Scans} scans";
                TestContext.WriteLine(text);
                Assert.That(seen[i], Is.GreaterThanOrEqualTo(Needed), text);
            }
        }

        // The detour is one wavelength: 29 dB over noise in free space, and nothing over the smooth sea.
        [Test]
        public void Buoy_InANullOfTheSmoothSea_IsLost()
        {
            double near = 1, far = 3;
            for (int halvings = 0; halvings < 50; halvings++)
            {
                double middle = (near + far) / 2;
                (near, far) = SeaFactor.Detour(AntennaHeight, 3.5, middle * 1852) > Wavelength
                    ? (middle, far) : (near, middle);
            }
            var buoys = new[] { ("buoy in the null", 3.5, near, 10.0) };
            Assert.That(Seen(0, buoys)[0], Is.EqualTo(Scans));
            Assert.That(Seen(1, buoys)[0], Is.LessThanOrEqualTo(1));
        }

        // M. I. Skolnik, An empirical formula for the radar cross section of ships at grazing incidence, IEEE Transactions
        // AES-10 (1974) 292: 52 f^(1/2) D^(3/2), MHz and kilotons. The gross tonnage in tons is taken for the displacement.
        static double Ship(double kilotons) => 52 * Math.Sqrt(9410) * Math.Pow(kilotons, 1.5);

        // A tenth of the face that the beam of 1.2 degrees covers: sigma0 = gamma sin(grazing angle), gamma -10 dB, as of
        // wooded hills (D. K. Barton, Land clutter models for radar design and analysis, Proceedings of the IEEE 73 (1985)
        // 198), on a face that is steep.
        static double Shore(double height, double miles) => 0.1 * height * miles * 1852 * math.radians(1.2);

        // Nulls are at whole wavelengths.
        static string NullOf(double waves) => Factor(waves) < -10
            ? $"in null {Math.Round(waves)}"
            : $"{Math.Abs(waves - Math.Round(waves)):0.00} wavelengths from null {Math.Round(waves)}";

        static double Factor(double waves) => 40 * Math.Log10(2 * Math.Abs(Math.Sin(Math.PI * waves)));

        // The radar equation, dB over noise in free space.
        static double Level(int target)
        {
            double gain = 26000 / (1.2 * 22), wave = 299792458 / 9.41e9, range = s_targets[target].miles * 1852;
            return 10 * Math.Log10(25000 * gain * gain * wave * wave * s_targets[target].section
                / (Math.Pow(4 * Math.PI, 3) * Math.Pow(range, 4)) / (1.380649e-23 * 290 * 10e6 * Math.Pow(10, 0.5)));
        }

        static int[] Seen(double reflection, (string, double height, double miles, double section)[] targets)
        {
            var radar = ScreenRadar.Default;
            (radar.Spokes, radar.Cells, radar.PulseNanoseconds) = (1024, 128, 100);
            (radar.RangeScale, radar.SeaReflection) = (21 * ScreenRadar.NauticalMile, reflection);
            var seen = new int[targets.Length];
            using (var tracer = new ScreenTracer(TestKernels.Screen, "test", radar))
            {
                var points = targets.Select((target, i) => tracer.Geometry.PointOf(new double3(
                    target.miles * 1852 * Math.Sin(Bearing(i)), target.height,
                    target.miles * 1852 * Math.Cos(Bearing(i))), new double3(0, AntennaHeight, 0),
                    target.section)).ToArray();
                var levels = new float[radar.Spokes * radar.Cells];
                tracer.Begin(0);
                for (int scan = 1; scan <= Scans; scan++)
                {
                    foreach (double turns in new[] { scan - 0.5, scan })
                    {
                        tracer.Begin(turns);
                        tracer.AddPoints(points, points.Length);
                        tracer.Finish(ScreenReceiver.Default);
                    }
                    tracer.Levels.ReadBack(levels, levels.Length);
                    for (int i = 0; i < points.Length; i++)
                        if (levels[points[i].Spoke * radar.Cells + points[i].Cell] > 10 * Math.Log10(-Math.Log(Rate)))
                            seen[i]++;
                }
            }
            return seen;
        }

        // Far apart, and away from north, where turns begin.
        static double Bearing(int target) => math.radians(20 + 35 * target);
    }
}
