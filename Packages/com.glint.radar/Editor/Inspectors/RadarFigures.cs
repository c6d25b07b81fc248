using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Editor
{
    /// <summary>
    /// Figures derived from a radar and the scene in their current state, without a trace.
    /// The target is the centre of the box around everything traced.
    /// </summary>
    sealed class RadarFigures
    {
        // Maximum factor for the number of rays across and down.
        const int MaxFactor = 16;

        readonly RadarPose _pose;
        readonly RayReadback _readback;

        /// <param name="pose">The pose.</param>
        /// <param name="boxes">Boxes of the pose's scene, which is not empty.</param>
        /// <param name="objects">Objects with a mesh.</param>
        public RadarFigures(in RadarPose pose, SceneBoxes boxes, int objects, RayReadback readback)
        {
            _pose = pose;
            _readback = readback;
            Objects = objects;
            Centre = boxes.Centre;
            TargetSize = math.length(boxes.Max - boxes.Min);
            double3 toCentre = Centre - pose.View.Position;
            Distance = math.length(toCentre);
            double depth = math.dot(toCentre, pose.View.Forward);
            if (depth > 0 || pose.View.IsParallel)
                Footprint = 2 * pose.View.HalfSize(pose.Settings) * (pose.View.IsParallel ? 1 : depth);
            Forecast = SamplingForecast.Of(pose.Settings, pose.View, Centre);
            Memory = DispatchPlan.Memory(pose, readback, SoftwareDevice.UsesWideKernels);
        }

        public RadarSettings Settings => _pose.Settings;

        /// <summary>The target, in the scene's metres.</summary>
        public double3 Centre { get; }

        /// <summary>Diagonal of the box around everything traced, metres.</summary>
        public double TargetSize { get; }

        /// <summary>Distance from the radar to the target, metres.</summary>
        public double Distance { get; }

        /// <summary>
        /// Width and height of the view in the plane of the target, metres; of the aperture for parallel rays.
        /// Null if the target is behind the radar.
        /// </summary>
        public double2? Footprint { get; }

        /// <summary>Distance from ray to ray at the target, across the view axis, metres.</summary>
        public double? RaySpacing => Footprint?.y / Settings.RaysDown;

        /// <summary>Objects with a mesh, and triangles.</summary>
        public long Objects { get; }

        public long Triangles => _pose.Scene.TriangleCount;

        /// <summary>Density of the rays returned by a mirror at the target; null if it returns none.</summary>
        public SamplingForecast? Forecast { get; }

        /// <summary>Bytes of a pose on the device and on this computer.</summary>
        public (double DeviceBytes, double HostBytes) Memory { get; }

        /// <summary>Maximum number of rays hit: those through the sphere around the target.</summary>
        public double MaxRaysHit => MaxRays(1);

        double MaxRays(int times) => RaySpacing is double spacing ? math.pow(times * TargetSize / spacing + 1, 2) : 0;

        /// <summary>
        /// Smallest factor, 2, 4, 8 or 16, for the rays across and down with which a mirror at the target would be
        /// sampled densely enough; null if none suffices or the memory does not.
        /// </summary>
        /// <param name="radar">Name for messages.</param>
        public int? EnoughTimes(string radar)
        {
            for (int times = 2; times <= MaxFactor; times *= 2)
            {
                var settings = Denser(_pose.Settings, times);
                if (!IsRoomFor(settings, radar))
                    return null;
                if (MaxRays(times) >= SamplingEstimate.FewestRays
                    && SamplingForecast.Of(settings, _pose.View, Centre) is SamplingForecast forecast
                    && !forecast.IsTooFew && !forecast.IsTooCoarse)
                    return times;
            }
            return null;
        }

        /// <summary>The same picture with a multiple of the rays across and down.</summary>
        public static RadarSettings Denser(RadarSettings settings, int times)
        {
            settings.RaysAcross *= times;
            settings.RaysDown *= times;
            settings.Region = new RayRegion
            {
                Left = times * settings.Region.Left, Bottom = times * settings.Region.Bottom,
                Width = times * settings.Region.Width, Height = times * settings.Region.Height
            };
            return settings;
        }

        bool IsRoomFor(in RadarSettings settings, string radar)
        {
            try
            {
                settings.Validate(radar);
                DispatchPlan.Check(settings, _readback, radar);
                return true;
            }
            catch (GlintException)
            {
                return false;
            }
        }

        /// <summary>The figures for an inspector: label, value, meaning.</summary>
        public IEnumerable<(string label, string value, string tooltip)> Rows()
        {
            yield return ("Wavelength", Length(Settings.Wavelength), "Speed of light over frequency.");
            yield return ("Rays", FormattableString.Invariant(
                    $"{Settings.RaysAcross} x {Settings.RaysDown}, {Settings.RaysEmitted:N0} emitted"),
                "Rays of the whole picture; those outside its region are not emitted.");
            yield return ("Distance", Length(Distance),
                "Distance from the radar to the centre of the traced objects' bounding box.");
            yield return (_pose.View.IsParallel ? "Aperture" : "Footprint",
                Footprint is double2 size ? $"{Length(size.x)} x {Length(size.y)}" : "behind the radar",
                _pose.View.IsParallel
                    ? "Width and height of the rectangle that the rays start from."
                    : "Width and height of the view at that distance.");
            if (RaySpacing is double spacing)
                yield return ("Ray spacing",
                    FormattableString.Invariant($"{Length(spacing)}, {spacing / Settings.Wavelength:0.##} wavelengths"),
                    "Distance between neighbouring rays at that distance, across the view axis.");
            if (Forecast is SamplingForecast forecast)
                yield return ("Path step", FormattableString.Invariant($"{forecast.LargestPathStep:0.###} wavelengths"),
                    "Path difference of neighbouring rays that a mirror at that distance, facing the radar, returns "
                        + "to the receiver. From half a wavelength the sum is no longer an integral.");
            yield return ("Traced", FormattableString.Invariant($"{Triangles:N0} triangles of {Objects:N0} objects"),
                "Active objects on the radar's layers and below its roots.");
            yield return ("Memory",
                $"{Text.Mebibytes(Memory.DeviceBytes)} on the device, {Text.Mebibytes(Memory.HostBytes)} here",
                "Estimates. On the device: BVHs, tiles, and the buffers of one dispatch. On the host: meshes and "
                    + "BVHs, and all rays if all are kept; each received ray takes some 130 bytes more.");
        }

        // At least three digits.
        static string Length(double metres) =>
            metres < 1 ? FormattableString.Invariant($"{1000 * metres:0.###} mm")
                : metres < 10000 ? FormattableString.Invariant($"{metres:0.##} m")
                : FormattableString.Invariant($"{metres / 1000:0.###} km");
    }
}
