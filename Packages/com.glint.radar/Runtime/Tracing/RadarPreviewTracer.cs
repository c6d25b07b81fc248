using System.Linq;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Traces a radar's view for display: the part of the view that hits anything, at about the resolution of a screen.
    /// </summary>
    sealed class RadarPreviewTracer
    {
        // Approximate number of pixels: 480 x 270.
        const double Pixels = 129600;

        // Margin around the visible part, as a fraction of its size.
        const double Margin = 0.04;

        // Maximum rays per ray of the radar: more would show detail that the radar does not sample.
        const double MaxPerRay = 16;

        readonly RayTracer _tracer;
        readonly RadarPose _pose;
        readonly CancellationToken _cancel;

        RadarPreviewTracer(RayTracer tracer, in RadarPose pose, CancellationToken cancel)
        {
            (_tracer, _pose, _cancel) = (tracer, pose, cancel);
        }

        /// <summary>The view of a pose whose scene the tracer holds.</summary>
        public static RadarPreviewImage Trace(RayTracer tracer, in RadarPose pose, CancellationToken cancel) =>
            new RadarPreviewTracer(tracer, pose, cancel).Trace();

        // Traces the whole view, then, if only a part of it hits anything, that part at a higher resolution.
        RadarPreviewImage Trace()
        {
            var coarse = Sized(Pixels);
            var whole = coarse.TracedRegion;
            var paths = Trace(coarse, whole);
            var hits = paths.Where(path => path.Bounces > 0).Select(path => path.Pixel).ToArray();
            if (hits.Length == 0)
                return Preview(coarse, whole, paths);
            var part = Around(hits, coarse);
            double share = (double)part.Width * part.Height / coarse.RayCount;
            var fine = Sized(math.min(Pixels / share, _pose.Settings.RayCount * MaxPerRay));
            part = Scaled(part, fine, coarse);
            return Preview(fine, part, Trace(fine, part));
        }

        RayPath[] Trace(in RadarSettings settings, in RayRegion part)
        {
            var pixels = new uint[part.Width * part.Height];
            for (int i = 0; i < pixels.Length; i++)
                pixels[i] = settings.PixelAt(part.Left + i % part.Width, part.Bottom + i / part.Width);
            return _tracer.TracePaths(new RadarPose(_pose.Scene, settings, _pose.View), pixels, null, _cancel);
        }

        static RadarPreviewImage Preview(in RadarSettings settings, in RayRegion part, RayPath[] paths)
        {
            var preview = new RadarPreviewImage(settings.RaysAcross, settings.RaysDown, part);
            foreach (var path in paths)
                preview.Set(path);
            return preview;
        }

        // The same picture with another number of rays, without the region, which refers to the original number.
        RadarSettings Sized(double rays)
        {
            var settings = _pose.Settings;
            settings.Region = default;
            double scale = math.sqrt(rays / settings.RayCount);
            settings.RaysAcross =
                (int)math.clamp(math.round(settings.RaysAcross * scale), 1, RadarSettings.RaysPerAxisLimit);
            settings.RaysDown =
                (int)math.clamp(math.round(settings.RaysDown * scale), 1, RadarSettings.RaysPerAxisLimit);
            return settings;
        }

        static RayRegion Around(uint[] pixels, in RadarSettings settings)
        {
            int2 first = int.MaxValue, last = 0;
            foreach (uint pixel in pixels)
            {
                var at = settings.PositionOf(pixel);
                (first, last) = (math.min(first, at), math.max(last, at));
            }
            int edge = 1 + (int)(Margin * math.cmax(last - first));
            first = math.max(0, first - edge);
            last = math.min(new int2(settings.RaysAcross, settings.RaysDown), last + 1 + edge);
            return new RayRegion
            {
                Left = first.x, Bottom = first.y, Width = last.x - first.x, Height = last.y - first.y
            };
        }

        static RayRegion Scaled(in RayRegion part, in RadarSettings to, in RadarSettings from)
        {
            double x = (double)to.RaysAcross / from.RaysAcross, y = (double)to.RaysDown / from.RaysDown;
            int left = (int)(part.Left * x), bottom = (int)(part.Bottom * y);
            return new RayRegion
            {
                Left = left, Bottom = bottom,
                Width = math.clamp((int)math.ceil(part.Width * x), 1, to.RaysAcross - left),
                Height = math.clamp((int)math.ceil(part.Height * y), 1, to.RaysDown - bottom)
            };
        }
    }
}
