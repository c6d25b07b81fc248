using System;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The path of one ray through the scene. Positions are in metres in the axes of the world, relative to the scene's
    /// origin (<see cref="RadarScene.Origin"/>).
    /// </summary>
    public struct RayPath
    {
        /// <summary>x + y * rays across; x from the left, y from the bottom of the picture.</summary>
        public uint Pixel;

        /// <summary>Start of the ray at the radar.</summary>
        public double3 Start;

        /// <summary>Its reflections in order; empty for a ray that hit nothing.</summary>
        public PathHit[] Hits;

        /// <summary>Point of a received ray on the receiver's plane; null if not received.</summary>
        public double3? End;

        /// <summary>Reflections made.</summary>
        public int Bounces => Hits.Length;

        /// <summary>True for a ray that reached the receiver.</summary>
        public bool IsReceived => End.HasValue;

        /// <summary>Whether the ray meets an object.</summary>
        /// <param name="isMeant">Tests the number of an object that the ray hits.</param>
        public bool Meets(Predicate<int> isMeant) => Array.Exists(Hits, hit => isMeant(hit.Object));

        /// <summary>Start, reflections and, if received, end: the points of its line.</summary>
        public double3[] Points()
        {
            var points = new double3[Hits.Length + (IsReceived ? 2 : 1)];
            points[0] = Start;
            for (int i = 0; i < Hits.Length; i++)
                points[i + 1] = Hits[i].Position;
            if (End is double3 end)
                points[points.Length - 1] = end;
            return points;
        }
    }

    /// <summary>A reflection of a ray.</summary>
    public struct PathHit
    {
        /// <summary>Point of reflection, metres, from the scene's origin.</summary>
        public double3 Position;

        /// <summary>Unit direction after the reflection.</summary>
        public double3 Direction;

        /// <summary>Place of the instance in <see cref="RadarScene.Instances"/>.</summary>
        public int Instance;

        /// <summary>Number of the triangle in the instance's mesh.</summary>
        public int Triangle;

        /// <summary>Number of the object that reflects; <see cref="MeshRange.NoObject"/> if it is not known.</summary>
        public int Object;

        /// <summary>Place of the surface that reflects in <see cref="RadarScene.Surfaces"/>.</summary>
        public int Surface;
    }
}
