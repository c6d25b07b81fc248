using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The input of a cross section: a scene, one direction of illumination, and what receives.</summary>
    public sealed class CrossSectionPose
    {
        /// <summary>Bend of an edge, degrees, above which it is sharp.</summary>
        public const double DefaultCreaseDegrees = SurfacePatches.DefaultCreaseDegrees;

        /// <summary>Default of <see cref="ToleranceDb"/>.</summary>
        public const double DefaultToleranceDb = 0.1;

        /// <summary>Tolerance of a radar's picture, decibels.</summary>
        public const double PictureToleranceDb = 1;

        const double MinRange = 1;

        /// <summary>The scene, metres.</summary>
        public RadarScene Scene { get; set; }

        /// <summary>The radar that illuminates.</summary>
        public RadarAspect Radar { get; set; }

        /// <summary>Those that receive, at the same range; <see cref="Radar"/> alone is monostatic.</summary>
        public RadarAspect[] Receivers { get; set; }

        /// <summary>
        /// The point that phases are relative to, in the scene's frame, metres: the incident wave has phase 0 there.
        /// </summary>
        public double3 PhaseCentre { get; set; }

        /// <summary>
        /// Distance from the phase centre to the radar and to each receiver, metres. Infinite: plane wave and far field.
        /// </summary>
        public double Range { get; set; } = double.PositiveInfinity;

        /// <summary>The part of the scene that the radar lights; null: all of it.</summary>
        public RadarFootprint Footprint { get; set; }

        /// <summary>Hertz, in ascending order.</summary>
        public double[] Frequencies { get; set; }

        /// <summary>The frequency of the reflection coefficients, hertz: the middle of the frequencies.</summary>
        public double CoefficientFrequency => FrequencyGroups.MiddleOf(Frequencies[0], Frequencies.Last());

        /// <summary>
        /// Middle of the band that the frequencies are of, hertz: the speckle of a sea is the same over the band. Null:
        /// each frequency has its own.
        /// </summary>
        public double? BandCentre { get; set; }

        /// <summary>
        /// Range resolution of what is made of the band, metres: facets of a sea that count for others stay below it.
        /// Infinite: nothing is.
        /// </summary>
        public double RangeCell { get; set; } = double.PositiveInfinity;

        /// <summary>
        /// Times of the pulses, seconds, 0 being the moment of the scene: each has all frequencies. What moves keeps
        /// its velocities, and what the radar sees of it.
        /// </summary>
        public double[] Times { get; set; } = { 0 };

        /// <summary>
        /// Factors of the wave number of all lengths at each of the times (<see cref="LookGroups"/>); null: 1.
        /// </summary>
        public double[] WaveFactors { get; set; }

        /// <summary>Number of <see cref="SampleOf">samples</see>.</summary>
        public int Samples => Times.Length * Frequencies.Length;

        /// <summary>Number of the sample of a pulse and a frequency.</summary>
        public int SampleOf(int pulse, int frequency) => pulse * Frequencies.Length + frequency;

        /// <summary>The frequency of a sample, hertz.</summary>
        public double FrequencyOf(int sample) => Frequencies[sample % Frequencies.Length];

        /// <summary>The frequency of a sample's phases, hertz.</summary>
        public double PhaseFrequencyOf(int sample) =>
            FrequencyOf(sample) * (WaveFactors?[sample / Frequencies.Length] ?? 1);

        /// <summary>The time of a sample, seconds.</summary>
        public double TimeOf(int sample) => Times[sample / Frequencies.Length];

        /// <summary>Whether paths change their lengths from pulse to pulse.</summary>
        public bool IsMoving => Scene.IsMoving && Times.Any(time => time != 0);

        /// <summary>Maximum number of bounces of a path, 1 to <see cref="RadarSettings.BounceLimit"/>.</summary>
        public int MaxBounces { get; set; } = RadarSettings.Default.MaxBounces;

        /// <summary>Above 0: only the contributions of this bounce.</summary>
        public int OnlyBounce { get; set; }

        /// <summary>Whether edges add their fringe fields.</summary>
        public bool HasEdges { get; set; } = true;

        /// <summary>Whether the currents of curved conductors fade towards the shadow.</summary>
        public bool FadesShadows { get; set; } = true;

        /// <summary>Bend of an edge, degrees, above which it is sharp and normals are not smoothed across it.</summary>
        public double CreaseDegrees { get; set; } = DefaultCreaseDegrees;

        /// <summary>
        /// The error asked for, decibels: of each complex amplitude at most 10^(tolerance / 20) - 1 of it, or of the
        /// floor where that is larger. It is the error of the integration, not of physical optics.
        /// </summary>
        public double ToleranceDb { get; set; } = DefaultToleranceDb;

        /// <summary>Those whose amplitudes are to have the error asked for; all are computed.</summary>
        public IReadOnlyList<Polarisation> Polarisations { get; set; } = Polarisation.CoPolar;

        /// <summary>
        /// Cross section below which the tolerance is that of this one, dBsm; null: <see cref="CrossSectionFloor"/>.
        /// </summary>
        public double? FloorDbsm { get; set; }

        /// <summary>
        /// The pose of a radar's picture: what its camera lights returns to it. The phase centre is the point of its
        /// axis beside the scene's centre; parallel rays are a plane wave. A scene with a sea lies on a curved earth.
        /// </summary>
        public static CrossSectionPose Of(in RadarPose pose)
        {
            var (view, scene) = (pose.View, pose.Scene);
            var (boxMin, boxMax) = scene.Bound();
            // Level in the middle of the scene, which is then the same wherever the radar is.
            if (scene.Seas.Count > 0 && !view.IsParallel)
                (view, scene) = (CurvedEarth.Below((boxMin + boxMax) / 2, view),
                    CurvedEarth.Below((boxMin + boxMax) / 2, scene));
            var radar = new RadarAspect(-view.Forward, view.Up, view.Right);
            double range = RangeOf(view, scene.BoundTarget((boxMin, boxMax)));
            return new CrossSectionPose
            {
                Scene = scene, Radar = radar, Receivers = new[] { radar },
                PhaseCentre = view.Position + range * view.Forward,
                Range = view.IsParallel ? double.PositiveInfinity : range,
                Footprint = new RadarFootprint(view, pose.Settings), Frequencies = new[] { pose.Settings.FrequencyHz },
                MaxBounces = pose.Settings.MaxBounces, ToleranceDb = PictureToleranceDb
            };
        }

        // To the middle of what is before the camera, whatever is behind it: of the water too, which may lie all around.
        static double RangeOf(in RadarView view, (double3 Min, double3 Max) target)
        {
            double nearest = double.PositiveInfinity, farthest = 0;
            for (int corner = 0; corner < 8; corner++)
            {
                double depth = math.dot(Box.CornerOf(target.Min, target.Max, corner) - view.Position, view.Forward);
                (nearest, farthest) = (Math.Min(nearest, depth), Math.Max(farthest, depth));
            }
            return Math.Max(MinRange, (Math.Max(0, nearest) + farthest) / 2);
        }

        /// <summary>Whether the radar is so far that its wave is plane.</summary>
        public bool IsFar => double.IsPositiveInfinity(Range);

        /// <summary>Whether the radar alone receives.</summary>
        public bool IsMonostatic => Receivers.Length == 1 && Receivers[0].ToRadar.Equals(Radar.ToRadar);

        /// <summary>How much nearer to the radar than the phase centre a position is, metres.</summary>
        public double NearerBy(double3 position)
        {
            double3 from = position - PhaseCentre;
            return IsFar ? math.dot(Radar.ToRadar, from) : Range - math.distance(Range * Radar.ToRadar, from);
        }

        /// <summary>Whether another pose differs in nothing but the aspects and the phase centre.</summary>
        public bool IsLike(CrossSectionPose other) => ReferenceEquals(Scene, other.Scene) && Range == other.Range
            && Footprint == null && other.Footprint == null && IsMonostatic == other.IsMonostatic
            && Receivers.Length == other.Receivers.Length && Frequencies.SequenceEqual(other.Frequencies)
            && BandCentre == other.BandCentre && Times.SequenceEqual(other.Times) && WaveFactors == other.WaveFactors
            && MaxBounces == other.MaxBounces && OnlyBounce == other.OnlyBounce
            && HasEdges == other.HasEdges && FadesShadows == other.FadesShadows && CreaseDegrees == other.CreaseDegrees
            && ToleranceDb == other.ToleranceDb && Polarisations.SequenceEqual(other.Polarisations)
            && FloorDbsm == other.FloorDbsm;
    }

    /// <summary>The default floor: the same for every pose of a target.</summary>
    public static class CrossSectionFloor
    {
        // Below the cross section of a sphere around the target.
        const double Decibels = 40;

        /// <summary>The floor of a target in a box, dBsm.</summary>
        public static double Of(double3 boxMin, double3 boxMax) =>
            10 * Math.Log10(Math.PI * math.lengthsq(boxMax - boxMin) / 4) - Decibels;

        /// <summary>The floor of a scene in a box, dBsm: that of its target.</summary>
        public static double Of(RadarScene scene, double3 boxMin, double3 boxMax)
        {
            var (targetMin, targetMax) = scene.BoundTarget((boxMin, boxMax));
            return Of(targetMin, targetMax);
        }
    }

    /// <summary>Direction and polarisations of a radar that looks at the phase centre.</summary>
    public readonly struct RadarAspect
    {
        /// <summary>An aspect; the three are unit vectors, across each other.</summary>
        public RadarAspect(double3 toRadar, double3 up, double3 right) => (ToRadar, Up, Right) = (toRadar, up, right);

        /// <summary>From the target to the radar.</summary>
        public double3 ToRadar { get; }

        /// <summary>Vertical polarisation: the radar's up.</summary>
        public double3 Up { get; }

        /// <summary>Horizontal polarisation: the radar's right.</summary>
        public double3 Right { get; }

        /// <summary>As of <see cref="At"/>, from -180 to 180.</summary>
        public double AzimuthDegrees => math.degrees(Math.Atan2(-ToRadar.x, -ToRadar.z));

        /// <summary>As of <see cref="At"/>.</summary>
        public double ElevationDegrees => math.degrees(Math.Asin(math.clamp(ToRadar.y, -1, 1)));

        /// <summary>
        /// The aspect of an upright radar. Azimuth 0 is on the -Z side and grows as Unity's rotation about Y; elevation
        /// is the angle above the horizontal. Degrees.
        /// </summary>
        public static RadarAspect At(double azimuthDegrees, double elevationDegrees)
        {
            double azimuth = math.radians(azimuthDegrees), elevation = math.radians(elevationDegrees);
            double sinA = Math.Sin(azimuth), cosA = Math.Cos(azimuth);
            double sinE = Math.Sin(elevation), cosE = Math.Cos(elevation);
            return new RadarAspect(new double3(-sinA * cosE, sinE, -cosA * cosE),
                new double3(sinA * sinE, cosE, cosA * sinE), new double3(cosA, 0, -sinA));
        }
    }
}
