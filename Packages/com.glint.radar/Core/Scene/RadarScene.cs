using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// What the radar sees: meshes, each at one or more places.
    /// BVHs over a mesh are kept as long as the same TriangleMesh comes again; a place may change at no cost.
    /// </summary>
    public sealed class RadarScene
    {
        /// <summary>A scene of meshes at places.</summary>
        /// <param name="instances">Kept, not copied.</param>
        public RadarScene(params MeshInstance[] instances) => Instances = instances;

        /// <summary>A scene of one mesh in the world's axes.</summary>
        public RadarScene(TriangleMesh mesh)
            : this(new MeshInstance { Mesh = mesh, ToWorld = Affine.Identity })
        {
        }

        /// <summary>The meshes, each at its place; in the order in which triangles are counted.</summary>
        public MeshInstance[] Instances { get; }

        /// <summary>
        /// Surfaces that ranges of the instances' triangles refer to; the first is the perfect conductor.
        /// </summary>
        public IReadOnlyList<SurfaceMaterial> Surfaces { get; set; } = new[] { SurfaceMaterial.PerfectConductor };

        /// <summary>
        /// Where in the world the origin of the places stands, metres: for what is written out,
        /// as the axes are the world's. Tracing needs none.
        /// </summary>
        public double3 Origin { get; set; }

        /// <summary>Whether both have the same meshes at the same places, with the same ranges and surfaces.</summary>
        internal bool IsSame(RadarScene other) =>
            Instances.AsSpan().SequenceEqual(other.Instances) && Surfaces.SequenceEqual(other.Surfaces);

        /// <summary>Triangles of all instances.</summary>
        public long TriangleCount => Instances.Sum(instance => (long)instance.Mesh.TriangleCount);
    }
}
