using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Scenes on an earth with straight rays: <see cref="ClutterGeometry.EarthRadius"/>.</summary>
    static class CurvedEarth
    {
        static readonly double3 s_up = new double3(0, 1, 0);

        /// <summary>
        /// A scene as a radar sees it: each instance is lower and tilted, by its distance from the radar. Tiles of a sea
        /// still join.
        /// </summary>
        /// <param name="radar">Its position, metres.</param>
        public static RadarScene Below(double3 radar, RadarScene scene)
        {
            var centres = new Dictionary<TriangleMesh, double3>();
            double3 CentreOf(TriangleMesh mesh)
            {
                if (!centres.TryGetValue(mesh, out var centre))
                {
                    var box = mesh.Bound();
                    centres.Add(mesh, centre = ((double3)box.Min + box.Max) / 2);
                }
                return centre;
            }
            var instances = scene.Instances.Select(it => Lowered(it, CentreOf(it.Mesh), radar)).ToArray();
            return new RadarScene(instances) { Surfaces = scene.Surfaces, Seas = scene.Seas, Origin = scene.Origin };
        }

        static MeshInstance Lowered(MeshInstance instance, double3 centre, double3 radar)
        {
            double3 at = instance.ToWorld.Point(centre), way = new double3(at.x - radar.x, 0, at.z - radar.z);
            double distance = math.length(way);
            if (!(distance > 0))
                return instance;
            double3 ahead = way / distance;
            double angle = distance / ClutterGeometry.EarthRadius, sine = Math.Sin(angle), versine = 1 - Math.Cos(angle);
            double3 Tilted(double3 v)
            {
                double along = math.dot(v, ahead);
                return v + (sine * v.y - versine * along) * ahead - (sine * along + versine * v.y) * s_up;
            }
            instance.ToWorld = new Affine
            {
                X = Tilted(instance.ToWorld.X), Y = Tilted(instance.ToWorld.Y), Z = Tilted(instance.ToWorld.Z),
                Origin = at + Tilted(instance.ToWorld.Origin - at) - ClutterGeometry.DropAt(distance) * s_up
            };
            return instance;
        }
    }
}
