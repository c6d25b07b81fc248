using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Lines for the paths of rays, as one mesh. Its vertices are relative to the centre of all lines, so that float32
    /// holds them in scenes far from the world's origin.
    /// </summary>
    sealed class PathLines
    {
        /// <summary>
        /// Colours of the segments in order, as in the published experiment; they repeat.
        /// </summary>
        public static readonly Color32[] SegmentColours =
        {
            new Color32(255, 0, 0, 255), new Color32(0, 255, 0, 255), new Color32(0, 64, 255, 255),
            new Color32(255, 255, 0, 255)
        };

        /// <summary>Colour of the receiver and of the points of reflection.</summary>
        public static readonly Color32 White = new Color32(255, 255, 255, 255);

        // Fractions of the size of all lines: length of the last segment of a ray that leaves the scene; half a cross.
        const double LeavingPart = 0.05, CrossPart = 0.003;

        readonly List<Vector3> _positions = new List<Vector3>();
        readonly List<Color32> _colours = new List<Color32>();
        readonly double3 _centre;
        readonly double _size;

        /// <param name="view">The radar's view, for the receiver's outline.</param>
        /// <param name="hitPoints">Draw a cross at each point of reflection.</param>
        public PathLines(in RadarView view, IReadOnlyList<RayPath> paths, bool hitPoints)
        {
            double3 boxMin = view.ReceiverCentre, boxMax = boxMin;
            foreach (var path in paths)
                foreach (var hit in path.Hits)
                    (boxMin, boxMax) = (math.min(boxMin, hit.Position), math.max(boxMax, hit.Position));
            _centre = (boxMin + boxMax) / 2;
            _size = math.length(boxMax - boxMin);
            AddReceiver(view);
            foreach (var path in paths)
                Add(path, hitPoints);
        }

        /// <summary>Writes the lines into a mesh.</summary>
        /// <returns>Position of the mesh's origin in the scene, metres.</returns>
        public double3 WriteTo(Mesh mesh)
        {
            mesh.Clear();
            mesh.SetVertices(_positions);
            mesh.SetColors(_colours);
            var indices = new int[_positions.Count];
            for (int i = 0; i < indices.Length; i++)
                indices[i] = i;
            mesh.SetIndices(indices, MeshTopology.Lines, 0);
            return _centre;
        }

        void Add(in RayPath path, bool hitPoints)
        {
            double3 from = path.Start;
            for (int i = 0; i < path.Hits.Length; i++)
            {
                double3 to = path.Hits[i].Position;
                Add(from, to, Colour(i));
                if (hitPoints)
                    AddCross(to);
                from = to;
            }
            if (path.Bounces > 0)
                Add(from, path.End ?? from + LeavingPart * _size * path.Hits[path.Bounces - 1].Direction,
                    Colour(path.Bounces));
        }

        void AddReceiver(in RadarView view)
        {
            double3 right = view.ReceiverSize.x / 2 * view.ReceiverRight,
                up = view.ReceiverSize.y / 2 * view.ReceiverUp, centre = view.ReceiverCentre;
            Add(centre - right - up, centre + right - up, White);
            Add(centre + right - up, centre + right + up, White);
            Add(centre + right + up, centre - right + up, White);
            Add(centre - right + up, centre - right - up, White);
        }

        void AddCross(double3 position)
        {
            double half = CrossPart * _size;
            Add(position - new double3(half, 0, 0), position + new double3(half, 0, 0), White);
            Add(position - new double3(0, half, 0), position + new double3(0, half, 0), White);
            Add(position - new double3(0, 0, half), position + new double3(0, 0, half), White);
        }

        static Color32 Colour(int segment) => SegmentColours[segment % SegmentColours.Length];

        void Add(double3 from, double3 to, Color32 colour)
        {
            _positions.Add((float3)(from - _centre));
            _positions.Add((float3)(to - _centre));
            _colours.Add(colour);
            _colours.Add(colour);
        }
    }
}
