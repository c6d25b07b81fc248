using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class IsarTransformTests
    {
        const double Azimuth = 20, Spacing = 5, Level = 2;
        const int LookCount = 72;

        static readonly FrequencyBand s_band = new FrequencyBand(9.85e9, 300e6 / 72, 72);

        // A bin of cross range equals one of range: both 0.5 m.
        static readonly double s_bin = s_band.RangeResolution,
            s_lookStep = PointEchoes.C / s_band.Centre / (2 * s_bin) / LookCount * 180 / Math.PI;

        /// <summary>
        /// 5 x 5 points 5 m apart, turned to 30 degrees: all are at their places within a tenth of a bin and equal
        /// within 0.3 dB. No mirror image of the turned grid falls on it.
        /// </summary>
        [Test]
        public void Image_OfAGridOfPoints_HasThemAtTheirPlacesWithTheirCrossSections()
        {
            var (sine, cosine) = (Math.Sin(Math.PI / 6), Math.Cos(Math.PI / 6));
            var points = Enumerable.Range(0, 25).Select(i => Spacing * new double2(i / 5 - 2, i % 5 - 2))
                .Select(at => new double2(cosine * at.x - sine * at.y, sine * at.x + cosine * at.y)).ToArray();
            var transform = NewTransform(32, 256, out var range);
            double[] levels = PowerLevel.Decibels(transform.Image(Profiles(points, range)));
            foreach (var point in points)
            {
                var (row, column) = ((int)Math.Round(Index(point.x)), (int)Math.Round(Index(point.y)));
                double[] down = Enumerable.Range(row - 4, 9).Select(i => levels[i * 256 + column]).ToArray(),
                    across = Enumerable.Range(column - 4, 9).Select(i => levels[row * 256 + i]).ToArray();
                var (downAt, downLevel) = PointEchoes.Peak(down);
                var (acrossAt, acrossLevel) = PointEchoes.Peak(across);
                Assert.That(transform.PlaceOf(row - 4 + downAt), Is.EqualTo(point.x).Within(0.1 * s_bin), "down range");
                Assert.That(transform.PlaceOf(column - 4 + acrossAt), Is.EqualTo(point.y).Within(0.1 * s_bin),
                    "cross range");
                Assert.That(new[] { downLevel, acrossLevel }, Is.All.EqualTo(10 * Math.Log10(Level)).Within(0.3));
            }

            double Index(double place) => (place - transform.PlaceOf(0)) / transform.Pixel;
        }

        /// <summary>Widths of a point at -3 dB are those of the window, along both axes.</summary>
        [Test]
        public void Image_OfAPoint_HasTheWindowsWidthOnBothAxes()
        {
            var transform = NewTransform(4, 201, out var range);
            double[] levels = PowerLevel.Decibels(transform.Image(Profiles(new[] { new double2(0, 0) }, range)));
            Assert.That(levels.Max(), Is.EqualTo(10 * Math.Log10(Level)).Within(0.05));
            AssertWidths(levels, transform, s_bin, s_bin);
        }

        /// <summary>
        /// The same at an elevation of 45 degrees, of azimuths and from a track: widths are those of the bins that the
        /// command prints. The point is the phase centre, whose responses are the same from everywhere.
        /// </summary>
        [Test]
        public void Image_AtAnElevation_HasTheWidthsOfItsBins([Values] bool isTrack)
        {
            const double elevation = 45, distance = 150;
            double[] steps = Enumerable.Range(0, LookCount).Select(look =>
                (look - 0.5 * (LookCount - 1)) * s_lookStep).ToArray(),
                frequencies = Enumerable.Range(0, s_band.Count).Select(s_band.Frequency).ToArray();
            var plan = isTrack
                ? new CrossSectionPlan(new RadarTrack(steps.Select(step => distance * math.radians(step)).ToArray(),
                    Azimuth, elevation, distance), frequencies)
                : new CrossSectionPlan(steps.Select(step => Azimuth + step).ToArray(), new[] { elevation },
                    frequencies);
            var looks = Enumerable.Range(0, LookCount).Select(look => plan[look * s_band.Count]).ToArray();
            var range = NewRange();
            var transform = new IsarTransform(range, s_band, looks.Select(look => look.Radar).ToArray(), Azimuth,
                Window.Named("taylor"), 4, 201, looks.Select(look => look.Range ?? double.PositiveInfinity).ToArray());
            var profile = range.Profile(PointEchoes.Point(s_band, 0, Level));
            AssertWidths(PowerLevel.Decibels(transform.Image(looks.Select(_ => profile).ToArray())), transform,
                IsarSettings.DownBin(s_band, plan), IsarSettings.CrossBin(s_band, plan));
        }

        static void AssertWidths(double[] levels, IsarTransform transform, double downBin, double crossBin)
        {
            Assert.That(Array.IndexOf(levels, levels.Max()), Is.EqualTo(100 * 201 + 100), "in the middle");
            foreach (var (stride, bin) in new[] { (1, crossBin), (201, downBin) })
                Assert.That(Enumerable.Range(-100, 201).Count(i =>
                        levels[100 * 202 + i * stride] > levels.Max() - 10 * Math.Log10(2)) * transform.Pixel,
                    Is.EqualTo(Window.Named("taylor").Width(0.5) * bin).Within(2 * transform.Pixel), $"{stride}");
        }

        /// <summary>
        /// The same from a straight track of 4.6 m, 150 m away and 40 degrees above the plane: its wave is curved by 0.3 m,
        /// ten wavelengths, at the corners.
        /// </summary>
        [Test]
        public void Image_FromATrack_HasPointsAtTheirPlacesWithTheirCrossSections()
        {
            const double distance = 150, elevation = 40;
            double ground = distance * Math.Cos(math.radians(elevation)), length = ground * LookCount * math.radians(s_lookStep);
            var track = new RadarTrack(Enumerable.Range(0, LookCount).Select(i =>
                length * ((i + 0.5) / LookCount - 0.5)).ToArray(), Azimuth, elevation, distance);
            double2[] points = { new double2(0, 0), new double2(-7, 7), new double2(7, 7), new double2(7, -7) };
            double azimuth = math.radians(Azimuth);
            double3 down = new double3(Math.Sin(azimuth), 0, Math.Cos(azimuth)),
                right = new double3(Math.Cos(azimuth), 0, -Math.Sin(azimuth)),
                middle = -ground * down + new double3(0, distance * Math.Sin(math.radians(elevation)), 0);
            var range = NewRange();
            var amplitudes = points.Select(_ => new Complex(Math.Sqrt(Level), 0)).ToArray();
            var profiles = track.Places.Select(along => range.Profile(PointEchoes.Sum(s_band, points.Select(point =>
            {
                double3 radar = middle + along * right;
                return 2 * (math.length(point.x * down + point.y * right - radar) - math.length(radar));
            }).ToArray(), amplitudes))).ToArray();
            var places = Enumerable.Range(0, LookCount).Select(i => track[i]).ToArray();
            var transform = new IsarTransform(range, s_band, places.Select(place =>
                    RadarAspect.At(place.azimuth, place.elevation)).ToArray(), Azimuth, Window.Named("taylor"), 20, 320,
                places.Select(place => place.range).ToArray());
            double[] levels = PowerLevel.Decibels(transform.Image(profiles));
            foreach (var point in points)
            {
                var near = Enumerable.Range(0, levels.Length).Where(i =>
                    math.distance(new double2(transform.PlaceOf(i / 320), transform.PlaceOf(i % 320)), point) < 2);
                int highest = near.OrderByDescending(i => levels[i]).First();
                // A tenth of a bin, and half a pixel.
                Assert.That(transform.PlaceOf(highest / 320), Is.EqualTo(point.x).Within(0.1 * s_bin + 0.04));
                Assert.That(transform.PlaceOf(highest % 320), Is.EqualTo(point.y).Within(0.1 * s_bin + 0.04));
                Assert.That(levels[highest], Is.EqualTo(10 * Math.Log10(Level)).Within(0.3));
            }
        }

        static IEnumerable<RadarAspect> Looks => Enumerable.Range(0, LookCount).Select(look =>
            RadarAspect.At(Azimuth + (look - 0.5 * (LookCount - 1)) * s_lookStep, 0));

        static RangeTransform NewRange() => new RangeTransform(s_band, Window.Named("taylor"), IsarTransform.Padding,
            -0.5 * s_band.UnambiguousRange);

        static IsarTransform NewTransform(double side, int pixels, out RangeTransform range)
        {
            range = NewRange();
            return new IsarTransform(range, s_band, Looks.ToArray(), Azimuth, Window.Named("taylor"), side, pixels);
        }

        // Points at places down range and cross range, summed term by term.
        static Complex[][] Profiles(double2[] points, RangeTransform range)
        {
            double azimuth = Azimuth * Math.PI / 180;
            double3 down = new double3(Math.Sin(azimuth), 0, Math.Cos(azimuth)),
                right = new double3(Math.Cos(azimuth), 0, -Math.Sin(azimuth));
            var amplitudes = points.Select(point => new Complex(Math.Sqrt(Level), 0)).ToArray();
            return Looks.Select(look => range.Profile(PointEchoes.Sum(s_band, points.Select(point =>
                -2 * math.dot(look.ToRadar, point.x * down + point.y * right)).ToArray(), amplitudes))).ToArray();
        }
    }
}
