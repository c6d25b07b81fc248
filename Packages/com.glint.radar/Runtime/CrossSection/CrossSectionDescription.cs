using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint
{
    /// <summary>Describes a run of cross sections for results.json.</summary>
    static class CrossSectionDescription
    {
        // In the words of conventions.md.
        const string Conventions = "S in m, cross section |S|^2, time factor exp(+j w t), phase exp(-j k L) about the "
            + "phase centre, V the radar's up and H its right, azimuth 0 on the -Z side and positive as a rotation "
            + "about Y; hv is received in H and sent in V";

        const string ErrorMeaning = "standard error of the integration over ray tubes, not of physical optics; "
            + "tolerance_met: 95 % of the complex amplitudes are within the tolerance";

        /// <summary>The description of a run.</summary>
        public static RunInfo Of(CrossSectionSetup setup)
        {
            var info = RunDescription.OfMachine();
            info.ScenePath = setup.ScenePath;
            info.Command = setup.Command;
            info.Objects = setup.Objects;
            info.ObjectNames = setup.HasContributions ? setup.ObjectNames : null;
            info.Triangles = setup.Scene.TriangleCount;
            info.Settings.Add(new RunSetting("conventions", Conventions));
            info.Settings.Add(new RunSetting("error", ErrorMeaning));
            info.Settings.Add(new RunSetting("polarisations", string.Join(",", setup.Polarisations)));
            info.Settings.Add(new RunSetting("tolerance", setup.ToleranceDb, "dB"));
            info.Settings.Add(new RunSetting("floor", setup.FloorDbsm, "dBsm"));
            RunDescription.Add(info, "phase_centre", setup.Scene.Origin + setup.PhaseCentre, "m");
            info.Settings.Add(new RunSetting("scene_radius", setup.Radius, "m"));
            info.Settings.Add(double.IsPositiveInfinity(setup.Range)
                ? new RunSetting("range", "far field")
                : new RunSetting("range", setup.Range, "m"));
            info.Settings.Add(new RunSetting("max_bounces", setup.MaxBounces, "1"));
            info.Settings.Add(new RunSetting("edges", setup.HasEdges ? "on" : "off"));
            info.Settings.Add(new RunSetting("contributions", setup.HasContributions ? "on" : "off"));
            info.Settings.Add(new RunSetting("crease", setup.CreaseDegrees, "deg"));
            info.Settings.Add(new RunSetting("materials",
                string.Join("; ", setup.UsedMaterials().Select(material => material.ToString()))));
            RunDescription.AddSeas(info, setup.Scene);
            setup.Echo?.AddTo(info.Settings, setup.Plan);
            if (setup.Plan.Pulses != null)
                info.Settings.Add(new RunSetting("motion", MotionOf(setup.Scene)));
            AddMeshes(info, setup);
            return info;
        }

        /// <summary>Identity of a run, in which its rows are resumed and merged.</summary>
        public static SweepIdentity IdentityOf(CrossSectionSetup setup)
        {
            var info = Of(setup);
            var identity = new SweepIdentity();
            setup.Plan.AddTo(identity);
            identity.Add("scene", info.ScenePath);
            identity.Add(SweepIdentity.Content, CrossSectionSetup.ContentOf(setup.Scene));
            RunDescription.AddTo(identity, info);
            return identity;
        }

        // Of each instance that moves, by its number.
        static string MotionOf(RadarScene scene)
        {
            var moving = Enumerable.Range(0, scene.Instances.Length)
                .Where(number => !scene.Instances[number].Motion.IsNone)
                .Select(number => FormattableString.Invariant($"{number}: {scene.Instances[number].Motion}")).ToArray();
            return moving.Length == 0 ? "none" : string.Join("; ", moving);
        }

        static void AddMeshes(RunInfo info, CrossSectionSetup setup)
        {
            info.Settings.Add(new RunSetting("meshes", string.Join(",", MeshHashes(setup.Scene))));
            info.Settings.Add(new RunSetting("mesh_sides", setup.Quality.IsOpen ? "open" : "closed"));
            double wavelength = Signal.Wavelength(setup.Plan.Frequencies.Last());
            info.Settings.Add(new RunSetting("coarse_area_share", setup.Quality.Share(wavelength), "1"));
            info.Settings.Add(double.IsPositiveInfinity(setup.Quality.MaxFrequency)
                ? new RunSetting("mesh_good_up_to", "any frequency")
                : new RunSetting("mesh_good_up_to", setup.Quality.MaxFrequency, "Hz"));
        }

        static IEnumerable<string> MeshHashes(RadarScene scene)
        {
            foreach (var mesh in scene.Instances.Select(instance => instance.Mesh).Distinct())
                using (var hash = new SceneHash())
                {
                    hash.Add(mesh.Vertices);
                    hash.Add(mesh.Indices);
                    yield return hash.Text();
                }
        }
    }
}
