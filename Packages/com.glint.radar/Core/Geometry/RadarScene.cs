using System.Linq;

namespace Glint.Core
{
    /// <summary>What the radar sees: meshes, each at one or more places. Trees over a mesh are kept as long as the same TriangleMesh comes again; a place may change at no cost.</summary>
    public sealed class RadarScene
    {
        public RadarScene(params MeshInstance[] instances) => Instances = instances;

        /// <summary>A scene of one mesh in the world's axes.</summary>
        public RadarScene(TriangleMesh mesh)
            : this(new MeshInstance { Mesh = mesh, ToWorld = Affine.Identity })
        {
        }

        public MeshInstance[] Instances { get; }

        /// <summary>Triangles of all instances.</summary>
        public long TriangleCount => Instances.Sum(instance => (long)instance.Mesh.TriangleCount);
    }
}
