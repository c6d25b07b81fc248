using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>Describes a run for results.json, and chooses its folder.</summary>
    public static class RunDescription
    {
        const string Tubes = "amplitudes integrated over ray tubes; rays_emitted, rays_hit, rays_received, ratio, "
            + "bounces, segments and path_length_m count the rays traced; sampling_error is the standard error of "
            + "amplitude_normalised; undersampled: 1 where the tolerance is not met";

        /// <summary>
        /// Name of a component's scene, for the folder of its results; a scene that was never saved has none.
        /// </summary>
        public static string SceneOf(Component component) =>
            string.IsNullOrEmpty(component.gameObject.scene.name) ? "Untitled" : component.gameObject.scene.name;

        /// <summary>Results/<paramref name="name"/> in the folder of <see cref="InProject"/>.</summary>
        /// <param name="table">What the rows hold; null: the poses of a sweep or run.</param>
        public static string DefaultFolder(string name, ResultTable table = null) =>
            InProject(Path.Combine("Results", name + table?.FolderSuffix));

        /// <summary>
        /// Resolves a path relative to the folder that holds Assets. A player has no project, and its own folder may be
        /// read-only: there the path is relative to Application.persistentDataPath.
        /// </summary>
        public static string InProject(string path) => Path.Combine(
            Application.isEditor ? Path.GetDirectoryName(Application.dataPath) : Application.persistentDataPath, path);

        /// <summary>The description of a run; its scene is gathered.</summary>
        /// <exception cref="GlintException">The radar or a mesh is not fit to be traced.</exception>
        public static RunInfo Of(SweepSetup setup)
        {
            var pose = setup.Radar.Gather();
            var info = OfMachine();
            info.ScenePath = setup.Scene;
            info.Command = setup.Command;
            info.TargetName = setup.Target == null ? null : setup.Target.name;
            info.Objects = setup.Radar.ObjectCount;
            info.Triangles = pose.Scene.TriangleCount;
            AddPicture(info, pose.Settings, pose.View, setup.Radar.IsFitted);
            info.Settings.Add(new RunSetting("receiver_width", pose.View.ReceiverSize.x, "m"));
            info.Settings.Add(new RunSetting("receiver_height", pose.View.ReceiverSize.y, "m"));
            Add(info, "radar", pose.Scene.Origin + pose.View.Position, "m");
            Add(info, "radar_forward", pose.View.Forward, "1");
            Add(info, "radar_up", pose.View.Up, "1");
            Add(info, "receiver", pose.Scene.Origin + pose.View.ReceiverCentre, "m");
            Add(info, "receiver_forward", pose.View.ReceiverForward, "1");
            Add(info, "receiver_up", pose.View.ReceiverUp, "1");
            AddSeas(info, pose.Scene);
            return info;
        }

        /// <summary>Adds the clutter of a scene's seas; nothing without any.</summary>
        internal static void AddSeas(RunInfo info, RadarScene scene)
        {
            if (scene.Seas.Count > 0)
                info.Settings.Add(new RunSetting("clutter", string.Join("; ", scene.Seas.Select(sea => sea.Clutter))));
        }

        /// <summary>The device and the versions.</summary>
        public static RunInfo OfMachine() => new RunInfo
        {
            DeviceName = SystemInfo.graphicsDeviceName,
            GraphicsApi = SystemInfo.graphicsDeviceVersion,
            GlintVersion = GlintVersion.Text,
            UnityVersion = Application.unityVersion,
            Host = RuntimeInformation.FrameworkDescription,
            OperatingSystem = SystemInfo.operatingSystem,
        };

        /// <summary>Identity of a sweep; the scene must be in its first pose.</summary>
        public static SweepIdentity IdentityOf(SweepSetup setup)
        {
            var info = Of(setup);
            var identity = new SweepIdentity();
            foreach (var axis in SweepAxis.All)
                if (setup.Plan.Has(axis))
                    identity.Add(axis.Column, string.Join(",", setup.Plan.Values(axis).Select(Numbers.Format)));
            identity.Add("scene", info.ScenePath);
            identity.Add("target", info.TargetName);
            if (setup.Target != null)
                identity.Add(SweepIdentity.TargetPlace, PlaceOf(setup.Target));
            identity.Add(SweepIdentity.Content, ContentOf(setup));
            AddTo(identity, info);
            return identity;
        }

        // The point that it turns about is not in the scene's content.
        static string PlaceOf(Transform target)
        {
            Vector3 position = target.position;
            Quaternion rotation = target.rotation;
            return PathOf(target) + " at " + string.Join(",", new double[]
            {
                position.x, position.y, position.z, rotation.x, rotation.y, rotation.z, rotation.w
            }.Select(Numbers.Format));
        }

        static string PathOf(Transform item) =>
            item.parent == null ? item.name : $"{PathOf(item.parent)}/{item.name}";

        /// <summary>Adds settings, device and versions to the identity of a sweep.</summary>
        internal static void AddTo(SweepIdentity identity, RunInfo info)
        {
            foreach (var setting in info.Settings)
                identity.Add(setting.Name,
                    setting.Unit == null ? setting.Text : $"{Numbers.Format(setting.Number)} {setting.Unit}");
            identity.Add("device", info.DeviceName);
            identity.Add("graphics_api", info.GraphicsApi);
            identity.Add("glint", info.GlintVersion);
            identity.Add("unity", info.UnityVersion);
        }

        // Hash of the scene in the first pose, and of the snapshots of later poses.
        static string ContentOf(SweepSetup setup)
        {
            using (var hash = new SceneHash())
            {
                hash.Add(setup.Radar.Gather().Scene);
                foreach (double snapshot in setup.Plan.Values(SweepAxis.Snapshot)?.Distinct()
                    ?? Enumerable.Empty<double>())
                {
                    var tile = setup.Sea.Snapshots[(int)snapshot - 1].Tile;
                    if (!tile.isReadable) // the trace refuses it by name
                        continue;
                    hash.Add(tile.vertices);
                    hash.Add(tile.triangles);
                }
                return hash.Text();
            }
        }

        static void AddPicture(RunInfo info, in RadarSettings settings, in RadarView view, bool isFitted)
        {
            info.Settings.Add(new RunSetting("frequency", settings.FrequencyHz, "Hz"));
            info.Settings.Add(new RunSetting("wavelength", settings.Wavelength, "m"));
            info.Settings.Add(new RunSetting("rays_across", settings.RaysAcross, "1"));
            info.Settings.Add(new RunSetting("rays_down", settings.RaysDown, "1"));
            if (!settings.Region.IsWhole)
                AddRegion(info, settings.Region);
            info.Settings.Add(new RunSetting("max_bounces", settings.MaxBounces, "1"));
            if (settings.ToleranceDb > 0)
            {
                info.Settings.Add(new RunSetting("tolerance", settings.ToleranceDb, "dB"));
                info.Settings.Add(new RunSetting("tolerance_floor", AmplitudeTracer.Floor, "1"));
                info.Settings.Add(new RunSetting("method", Tubes));
            }
            if (settings.SkipSamplingError)
                info.Settings.Add(new RunSetting(ResultColumn.SamplingError.Name, ResultColumn.NotEstimated));
            info.Settings.Add(new RunSetting("projection", view.IsParallel ? "parallel" : "perspective"));
            if (!view.IsParallel)
            {
                info.Settings.Add(new RunSetting("vertical_fov", view.VerticalFovDegrees, "deg"));
                return;
            }
            info.Settings.Add(new RunSetting("aperture", isFitted ? "fitted" : "given"));
            info.Settings.Add(new RunSetting("aperture_width", 2 * view.HalfSize(settings).x, "m"));
            info.Settings.Add(new RunSetting("aperture_height", view.ApertureHeight, "m"));
            info.Settings.Add(new RunSetting("ray_spacing", view.ApertureHeight / settings.RaysDown, "m"));
        }

        static void AddRegion(RunInfo info, RayRegion region)
        {
            info.Settings.Add(new RunSetting("region_left", region.Left, "1"));
            info.Settings.Add(new RunSetting("region_bottom", region.Bottom, "1"));
            info.Settings.Add(new RunSetting("region_width", region.Width, "1"));
            info.Settings.Add(new RunSetting("region_height", region.Height, "1"));
        }

        internal static void Add(RunInfo info, string what, double3 vector, string unit)
        {
            info.Settings.Add(new RunSetting($"{what}_x", vector.x, unit));
            info.Settings.Add(new RunSetting($"{what}_y", vector.y, unit));
            info.Settings.Add(new RunSetting($"{what}_z", vector.z, unit));
        }
    }

    /// <summary>
    /// Identifies the content of a scene across runs and machines: SHA-256 over the bytes of its numbers,
    /// little-endian.
    /// </summary>
    sealed class SceneHash : IDisposable
    {
        // 32 of 64 digits: 128 bits make collisions negligible.
        const int Digits = 32;

        readonly IncrementalHash _hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);

        /// <summary>Adds meshes and transforms, each mesh once.</summary>
        public void Add(RadarScene scene)
        {
            var meshes = new Dictionary<TriangleMesh, int>();
            foreach (var instance in scene.Instances)
            {
                if (!meshes.TryGetValue(instance.Mesh, out int number))
                {
                    meshes.Add(instance.Mesh, number = meshes.Count);
                    Add(instance.Mesh.Vertices);
                    Add(instance.Mesh.Indices);
                }
                Add(new[] { number });
                Add(new[] { instance.ToWorld });
            }
            // Scenes of perfect conductors alone keep the hash that they had before there were surfaces.
            if (scene.Surfaces.Count == 1)
                return;
            foreach (var instance in scene.Instances)
                Add(instance.Ranges.SelectMany(range => new[] { range.FirstTriangle, range.Surface }).ToArray());
            foreach (var surface in scene.Surfaces)
                Add(surface.ToString().ToCharArray());
        }

        /// <summary>Adds numbers or structs of numbers, and their count.</summary>
        public void Add<T>(T[] values) where T : struct
        {
            _hash.AppendData(BitConverter.GetBytes(values.Length));
            _hash.AppendData(MemoryMarshal.AsBytes(new ReadOnlySpan<T>(values)));
        }

        /// <summary>The hash of everything added, in hexadecimal digits; resets the hash.</summary>
        public string Text() =>
            BitConverter.ToString(_hash.GetHashAndReset()).Replace("-", "").ToLowerInvariant().Substring(0, Digits);

        public void Dispose() => _hash.Dispose();
    }
}
