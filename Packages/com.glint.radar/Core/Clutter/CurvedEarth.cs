using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Scenes on an earth with straight rays: <see cref="ClutterGeometry.EarthRadius"/>.</summary>
    public static class CurvedEarth
    {
        static readonly double3 s_up = new double3(0, 1, 0);

        /// <summary>
        /// A scene on the earth: each instance is lower and tilted, by its distance from where the earth is level. Tiles
        /// of a sea still join.
        /// </summary>
        /// <param name="level">A point above or below that place, metres.</param>
        public static RadarScene Below(double3 level, RadarScene scene)
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
            var instances = scene.Instances.Select(it => Lowered(it, CentreOf(it.Mesh), level)).ToArray();
            return new RadarScene(instances) { Surfaces = scene.Surfaces, Seas = scene.Seas, Origin = scene.Origin };
        }

        /// <summary>A radar above such a scene: lower, and tilted.</summary>
        public static RadarView Below(double3 level, RadarView view)
        {
            var place = new Curvature(view.Position, level);
            view.Position -= place.Drop * s_up;
            (view.Right, view.Up, view.Forward) =
                (place.Tilted(view.Right), place.Tilted(view.Up), place.Tilted(view.Forward));
            return view;
        }

        static MeshInstance Lowered(MeshInstance instance, double3 centre, double3 level)
        {
            double3 at = instance.ToWorld.Point(centre);
            var place = new Curvature(at, level);
            instance.ToWorld = new Affine
            {
                X = place.Tilted(instance.ToWorld.X), Y = place.Tilted(instance.ToWorld.Y),
                Z = place.Tilted(instance.ToWorld.Z),
                Origin = at + place.Tilted(instance.ToWorld.Origin - at) - place.Drop * s_up
            };
            return instance;
        }

        // What is at a place is lower, and tilted away from where the earth is level.
        readonly struct Curvature
        {
            readonly double3 _ahead;
            readonly double _sine, _versine;

            public Curvature(double3 at, double3 level)
            {
                double3 way = new double3(at.x - level.x, 0, at.z - level.z);
                double distance = math.length(way), angle = distance / ClutterGeometry.EarthRadius;
                _ahead = distance > 0 ? way / distance : 0;
                (_sine, _versine) = (Math.Sin(angle), 1 - Math.Cos(angle));
                Drop = ClutterGeometry.DropAt(distance);
            }

            public double Drop { get; }

            public double3 Tilted(double3 v)
            {
                double along = math.dot(v, _ahead);
                return v + (_sine * v.y - _versine * along) * _ahead - (_sine * along + _versine * v.y) * s_up;
            }
        }
    }
}
