using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Editor
{
    /// <summary>Boxes around everything traced. The box of a mesh is cached.</summary>
    sealed class SceneBoxes
    {
        Dictionary<TriangleMesh, Box> _boxes = new Dictionary<TriangleMesh, Box>();

        /// <summary>Corners of the box around all triangles, in the scene's axes and metres.</summary>
        public double3 Min { get; private set; }

        public double3 Max { get; private set; }

        public bool IsEmpty => !(Min.x <= Max.x);

        public double3 Centre => (Min + Max) / 2;

        /// <summary>Updates the boxes to a scene.</summary>
        public void Update(RadarScene scene)
        {
            var before = _boxes;
            _boxes = new Dictionary<TriangleMesh, Box>();
            (Min, Max) = (double.PositiveInfinity, double.NegativeInfinity);
            foreach (var instance in scene.Instances)
            {
                if (!_boxes.TryGetValue(instance.Mesh, out var box))
                    _boxes.Add(instance.Mesh,
                        box = before.TryGetValue(instance.Mesh, out var known) ? known : instance.Mesh.Bound());
                if (instance.Mesh.TriangleCount > 0)
                    Add(box, instance.ToWorld);
            }
        }

        /// <summary>Whether any box can be in the picture, or in its region.</summary>
        public bool AreSeen(in RadarPose pose)
        {
            var tiles = new PictureTiles(pose.Settings, pose.View);
            foreach (var instance in pose.Scene.Instances)
                if (instance.Mesh.TriangleCount > 0 && tiles.CanSee(_boxes[instance.Mesh], instance.ToWorld))
                    return true;
            return false;
        }

        void Add(in Box box, in Affine toWorld)
        {
            for (int corner = 0; corner < 8; corner++)
            {
                double3 p = toWorld.Point(box.Corner(corner));
                Min = math.min(Min, p);
                Max = math.max(Max, p);
            }
        }
    }
}
