using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Editor
{
    /// <summary>Opens what a stored run was traced from, puts one of its poses up again, and traces what a report shows of it.</summary>
    sealed class SceneCapture
    {
        /// <summary>Ways of rays at most.</summary>
        public const int MostPaths = 2000;

        // Rays that are held at a time: 25 MB.
        const int RaysAtOnce = 1 << 19;

        // Pixels of the picture, about: 480 x 270.
        const double PicturePixels = 129600;

        readonly RayTracer _tracer;
        readonly RadarPose _pose;
        readonly IProgressSink _progress;

        SceneCapture(RayTracer tracer, in RadarPose pose, IProgressSink progress)
        {
            _tracer = tracer;
            _pose = pose;
            _progress = progress;
        }

        /// <summary>What a report shows of a pose.</summary>
        /// <param name="number">Of the pose, from 0.</param>
        /// <exception cref="GlintException">The scene or mesh file is not there any more, or cannot be traced.</exception>
        /// <exception cref="OperationCanceledException">Cancelled.</exception>
        public static ReportScene Of(StoredRun run, int number, IProgressSink progress)
        {
            var subjects = SceneSubjects.Open(LineOf(run));
            var plan = new SweepPlan(SweepAxis.All.Select(axis => (axis, Only(axis == SweepAxis.Angle && subjects.Target == null ? null : run.Value(number, axis)))).ToArray());
            progress.Start(subjects.Name, 1);
            try
            {
                using (var sweep = new SweepRun(subjects.Radar, plan, subjects.Target, subjects.Sea, subjects.Scene, null, subjects.Mount))
                {
                    var scene = new ReportScene { Number = number, Result = sweep.Step(progress, progress.Cancel).Result, Pose = subjects.Radar.Gather() };
                    subjects.Radar.Release(); // its trees are made once more, below
                    using (var tracer = new RayTracer(subjects.Radar.Kernel, subjects.Name))
                    {
                        tracer.SetScene(scene.Pose.Scene, progress.Cancel);
                        var capture = new SceneCapture(tracer, scene.Pose, progress);
                        scene.Paths = capture.Paths();
                        scene.Picture = capture.Picture();
                    }
                    progress.Advance(1, null);
                    return scene;
                }
            }
            finally
            {
                progress.Finish();
                subjects.Radar.Release();
            }
        }

        static IReadOnlyList<double> Only(double? value) => value.HasValue ? new[] { value.Value } : null;

        // The command that was given; a Sweep component's run has none, and is of the scene as it stands.
        static CommandLine LineOf(StoredRun run)
        {
            if (run.Command != null)
                return CommandLine.Parse(run.Command.FirstOrDefault() == Commands.Run.Name ? Commands.Run : Commands.Sweep, run.Command.Skip(1).ToArray());
            if (string.IsNullOrEmpty(run.ScenePath))
                throw new GlintException("the results name no scene: it was not saved when it was traced");
            var words = new List<string> { "--", run.ScenePath };
            if (run.Count > 0 && run.Value(0, SweepAxis.Snapshot) != null)
                words.Insert(0, $"{Options.Snapshots.Flag}=1");
            if (run.TargetName != null)
                words.InsertRange(0, new[] { $"{Options.Target.Flag}={run.TargetName}", $"{Options.Angles.Flag}=0" });
            return CommandLine.Parse(words.Count > 2 ? Commands.Sweep : Commands.Run, words);
        }

        // With a limit of n reflections a ray ends at its n-th: a pass for each gives all points.
        IReadOnlyList<double3[]> Paths()
        {
            var received = Trace(_pose.Settings, KeptRays.Received);
            int count = math.min(received.Length, MostPaths);
            var chosen = Enumerable.Range(0, count).Select(i => received[(long)i * received.Length / count]).ToDictionary(ray => ray.Pixel);
            var points = chosen.ToDictionary(ray => ray.Key, ray => new List<double3> { StartOf(_pose.Settings, ray.Key) });
            for (int bounce = 1; chosen.Values.Any(ray => ray.Bounces > bounce); bounce++)
            {
                var settings = _pose.Settings;
                settings.MaxBounces = bounce;
                foreach (var part in Parts(chosen.Values.Where(ray => ray.Bounces > bounce).Select(ray => ray.Pixel)))
                {
                    settings.Region = part;
                    foreach (var ray in Trace(settings, KeptRays.All))
                        if (ray.Bounces == bounce && chosen.TryGetValue(ray.Pixel, out var whole) && whole.Bounces > bounce)
                            points[ray.Pixel].Add((double3)ray.LastHit);
                }
            }
            foreach (var ray in chosen.Values)
            {
                double3 last = (double3)ray.LastHit, direction = (double3)ray.Direction;
                points[ray.Pixel].Add(last);
                points[ray.Pixel].Add(last + math.dot(_pose.View.ReceiverCentre - last, _pose.View.ReceiverForward) / math.dot(direction, _pose.View.ReceiverForward) * direction);
            }
            // A point that a pass did not give leaves a way that never was.
            return chosen.Values.Where(ray => points[ray.Pixel].Count == ray.Bounces + 2).Select(ray => points[ray.Pixel].ToArray()).ToArray();
        }

        // Rows of the rectangle around some pixels, as many at a time as are held.
        IEnumerable<RayRegion> Parts(IEnumerable<uint> pixels)
        {
            uint across = (uint)_pose.Settings.RaysAcross;
            int left = int.MaxValue, right = 0, bottom = int.MaxValue, top = 0;
            foreach (uint pixel in pixels)
            {
                (left, right) = (math.min(left, (int)(pixel % across)), math.max(right, (int)(pixel % across)));
                (bottom, top) = (math.min(bottom, (int)(pixel / across)), math.max(top, (int)(pixel / across)));
            }
            int width = right - left + 1, rows = math.max(1, RaysAtOnce / width);
            for (; bottom <= top; bottom += rows)
                yield return new RayRegion { Left = left, Bottom = bottom, Width = width, Height = math.min(rows, top + 1 - bottom) };
        }

        // First the whole at its size, then, where only a part of it meets anything, that part larger.
        RadarPicture Picture()
        {
            var settings = Sized(PicturePixels);
            var hits = Trace(First(settings), KeptRays.All).Where(ray => ray.Bounces > 0).Select(ray => ray.Pixel).ToArray();
            if (hits.Length == 0)
                return PictureOf(settings);
            var part = Around(hits, settings, 0.04);
            double share = (double)part.Width * part.Height / settings.RayCount;
            settings = Sized(math.min(PicturePixels / share, _pose.Settings.RayCount * 16.0));
            settings.Region = Scaled(part, settings, Sized(PicturePixels));
            return PictureOf(settings);
        }

        RadarPicture PictureOf(RadarSettings settings)
        {
            var part = settings.Region.IsWhole ? new RayRegion { Width = settings.RaysAcross, Height = settings.RaysDown } : settings.Region;
            var picture = new RadarPicture(settings.RaysAcross, settings.RaysDown, part);
            var first = Trace(First(settings), KeptRays.All);
            var last = Trace(settings, KeptRays.All);
            for (int i = 0; i < first.Length; i++)
                picture.Set(last[i].Pixel, (int)last[i].Bounces, last[i].IsReceived, first[i].Bounces > 0 ? Facing(settings, first[i]) : 0);
            return picture;
        }

        // A mirror turns a direction by twice its part along the normal.
        double Facing(in RadarSettings settings, in RayData ray)
        {
            double3 before = _pose.View.IsParallel ? _pose.View.Forward : math.normalize((double3)ray.LastHit - StartOf(settings, ray.Pixel));
            return math.length((double3)ray.Direction - before) / 2;
        }

        // The same picture of about so many rays; a region is for its own number of rays.
        RadarSettings Sized(double rays)
        {
            var settings = _pose.Settings;
            settings.Region = default;
            double scale = math.sqrt(rays / settings.RayCount);
            settings.RaysAcross = (int)math.clamp(math.round(settings.RaysAcross * scale), 1, RadarSettings.RaysPerAxisLimit);
            settings.RaysDown = (int)math.clamp(math.round(settings.RaysDown * scale), 1, RadarSettings.RaysPerAxisLimit);
            return settings;
        }

        static RadarSettings First(RadarSettings settings)
        {
            settings.MaxBounces = 1;
            return settings;
        }

        static RayRegion Around(uint[] pixels, in RadarSettings settings, double margin)
        {
            uint across = (uint)settings.RaysAcross;
            int left = (int)pixels.Min(pixel => pixel % across), right = (int)pixels.Max(pixel => pixel % across), bottom = (int)pixels.Min(pixel => pixel / across), top = (int)pixels.Max(pixel => pixel / across);
            int edge = 1 + (int)(margin * math.max(right - left, top - bottom));
            (left, bottom) = (math.max(0, left - edge), math.max(0, bottom - edge));
            return new RayRegion { Left = left, Bottom = bottom, Width = math.min(settings.RaysAcross, right + 1 + edge) - left, Height = math.min(settings.RaysDown, top + 1 + edge) - bottom };
        }

        static RayRegion Scaled(in RayRegion part, in RadarSettings to, in RadarSettings from)
        {
            double x = (double)to.RaysAcross / from.RaysAcross, y = (double)to.RaysDown / from.RaysDown;
            int left = (int)(part.Left * x), bottom = (int)(part.Bottom * y);
            return new RayRegion
            {
                Left = left, Bottom = bottom,
                Width = math.clamp((int)math.ceil(part.Width * x), 1, to.RaysAcross - left), Height = math.clamp((int)math.ceil(part.Height * y), 1, to.RaysDown - bottom)
            };
        }

        RayData[] Trace(in RadarSettings settings, KeptRays keep) => _tracer.Trace(settings, _pose.View, keep, _progress, _progress.Cancel).Rays;

        // Where the ray of a pixel leaves.
        double3 StartOf(in RadarSettings settings, uint pixel)
        {
            if (!_pose.View.IsParallel)
                return _pose.View.Position;
            double2 half = _pose.View.HalfSize(settings);
            double x = (2.0 * (pixel % (uint)settings.RaysAcross) + 1) / settings.RaysAcross - 1, y = (2.0 * (pixel / (uint)settings.RaysAcross) + 1) / settings.RaysDown - 1;
            return _pose.View.Position + x * half.x * _pose.View.Right + y * half.y * _pose.View.Up;
        }
    }
}
