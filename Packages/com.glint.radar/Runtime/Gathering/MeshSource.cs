using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The state of a Mesh in the last gather, and its triangles in its own coordinates if an instance needs them.
    /// </summary>
    sealed class MeshSource
    {
        // Distance of the vertices' centre from the mesh's origin, in half sizes of their box, above which the mesh is
        // far from its origin.
        const double FarInHalves = 3;

        bool _isKnown, _isUnconfirmed, _hasFrame;
        ulong? _signs; // null: the content must be hashed
        TriangleMesh _triangles;
        VertexFrame _frame;

        public Mesh Mesh { get; private set; }

        /// <summary>Hash of the content: <see cref="ContentHash"/>.</summary>
        public ulong Hash { get; private set; }

        /// <summary>Number of changes seen; above 0 the mesh counts as changing.</summary>
        public int Version { get; private set; }

        public int VertexCount { get; private set; }

        public int TriangleCount { get; private set; }

        /// <summary>Triangles of each submesh, in order.</summary>
        public int[] SubmeshTriangles { get; private set; }

        /// <summary>Half sizes and centre of the box around the vertices, in the mesh's coordinates.</summary>
        public double3 Half { get; private set; }

        public double3 Centre { get; private set; }

        /// <summary>Number of objects of this gather with the mesh.</summary>
        public int ObjectCount { get; private set; }

        /// <summary>
        /// Reads the mesh if it has changed. Its content is hashed if its signs differ, or if it is watched.
        /// </summary>
        /// <param name="owner">Renderer of the mesh, for messages.</param>
        /// <param name="isWatched">Whether the mesh may change without a change of its signs.</param>
        /// <param name="confirmLater">A watched mesh is not hashed here, but in <see cref="Confirm"/>.</param>
        /// <exception cref="GlintException">The mesh cannot be traced.</exception>
        public void Update(Mesh mesh, MeshReader reader, Renderer owner, bool isWatched, bool confirmLater)
        {
            (Mesh, ObjectCount, _hasFrame) = (mesh, 0, false);
            ulong signs = MeshWatch.Signs(mesh);
            bool hasSameSigns = _signs == signs;
            _isUnconfirmed = hasSameSigns && isWatched && confirmLater;
            if (_isUnconfirmed || hasSameSigns && !isWatched)
                return;
            ulong hash = reader.Hash(mesh);
            if (!_isKnown || hash != Hash)
                Read(mesh, hash, reader, owner);
            _signs = signs; // not of a mesh that was refused
        }

        /// <summary>
        /// Hashes the mesh if the last gather took it as unchanged without reading it.
        /// </summary>
        /// <returns>False if it has changed; the next gather reads it.</returns>
        public bool Confirm(MeshReader reader)
        {
            if (_isUnconfirmed && (Mesh == null || reader.Hash(Mesh) != Hash))
                _signs = null;
            _isUnconfirmed = false;
            return _signs != null;
        }

        void Read(Mesh mesh, ulong hash, MeshReader reader, Renderer owner)
        {
            SubmeshTriangles = reader.CountTriangles(mesh, owner);
            TriangleCount = SubmeshTriangles.Sum();
            VertexCount = mesh.vertexCount;
            reader.Measure(mesh, out var boxMin, out var boxMax);
            (Half, Centre) = (((double3)boxMax - boxMin) / 2, ((double3)boxMax + boxMin) / 2);
            Version += _isKnown ? 1 : 0;
            (Hash, _isKnown, _triangles) = (hash, true, null);
        }

        /// <summary>Counts an object with the mesh.</summary>
        public void AddObject() => ObjectCount++;

        /// <summary>Refuses a transform that puts a vertex too far from the scene's origin.</summary>
        /// <param name="owner">Renderer of the mesh, for the message.</param>
        /// <exception cref="GlintException">A vertex is too far away; the message names it.</exception>
        public void CheckTransform(in Affine toScene, MeshReader reader, Renderer owner)
        {
            if (VertexCount == 0)
                return;
            Bound(toScene, out var centre, out var half);
            if (!math.all(math.abs(centre) + half <= TriangleMesh.LargestCoordinate))
                reader.CheckTransform(Mesh, toScene, owner);
        }

        /// <summary>A box around the transformed vertices.</summary>
        public void Bound(in Affine transform, out double3 centre, out double3 half)
        {
            centre = transform.Point(Centre);
            half = math.abs(transform.X) * Half.x + math.abs(transform.Y) * Half.y + math.abs(transform.Z) * Half.z;
        }

        /// <summary>An instance of the mesh with its own vertices.</summary>
        public MeshInstance MakeInstance(in Affine toScene, MeshReader reader)
        {
            // The first transform of a gather sets the unit of the mesh.
            double unit = _hasFrame ? _frame.Unit : TransformMath.Unit(toScene);
            _hasFrame = true;
            if (_triangles == null || unit != _frame.Unit)
                Build(reader, unit);
            return new MeshInstance { Mesh = _triangles, ToWorld = toScene * _frame.Back };
        }

        void Build(MeshReader reader, double unit)
        {
            _frame = new VertexFrame(Centre, Half, unit);
            // Subtracted only if it is as large as the vertices: then float32 does not round.
            _frame.Origin = math.select(0, _frame.Origin, math.abs(Centre) > FarInHalves * math.cmax(Half));
            var vertices = new float3[VertexCount];
            var indices = new int[3 * TriangleCount];
            int vertexCount = 0, indexCount = 0;
            reader.Append(Mesh, _frame.Into, vertices, ref vertexCount, indices, ref indexCount);
            _triangles = new TriangleMesh(vertices, indices);
        }
    }
}
