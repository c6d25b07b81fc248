using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Objects of a <see cref="RigidGroup"/>, merged into one mesh in its frame.
    /// It is rebuilt only if one of them changes.
    /// </summary>
    sealed class MergedMesh
    {
        List<Part> _parts = new List<Part>(), _merged = new List<Part>();
        readonly List<TransformNode> _nodes = new List<TransformNode>();
        RigidGroup _group;
        TransformNode _first;
        TriangleMesh _mesh;
        VertexFrame _vertexFrame;

        /// <summary>Begins a gather with the object that names the mesh.</summary>
        public void Begin(TransformNode first, RigidGroup group)
        {
            (_first, _group) = (first, group);
            _parts.Clear();
            _nodes.Clear();
            Add(first);
        }

        /// <summary>Adds an object of the same group.</summary>
        public void Add(TransformNode node)
        {
            _parts.Add(new Part { Source = node.Source, Version = node.Source.Version, InFrame = _group.Into(node) });
            _nodes.Add(node);
        }

        /// <summary>The objects, in the order of their triangles.</summary>
        public IReadOnlyList<TransformNode> Nodes => _nodes;

        /// <summary>The mesh at the current transform of the group's frame.</summary>
        public MeshInstance MakeInstance(MeshReader reader)
        {
            // The scale of a lone stretched object is applied to its vertices: a BVH over undistorted shapes is better,
            // and bends are compared with the crease angle in the mesh.
            if (_parts.Count == 1 && TransformMath.Conditioning(_first.ToScene) >= TransformMath.SimilarConditioning)
            {
                (_mesh, _merged) = (null, new List<Part>());
                return _parts[0].Source.MakeInstance(_first.ToScene, reader);
            }
            if (_mesh == null || _vertexFrame.Unit != _group.Unit || !IsMerged())
                Merge(_group.Unit, reader);
            return new MeshInstance { Mesh = _mesh, ToWorld = _group.ToScene * _vertexFrame.Back };
        }

        bool IsMerged()
        {
            if (_parts.Count != _merged.Count)
                return false;
            for (int i = 0; i < _parts.Count; i++)
                if (!_parts[i].Equals(_merged[i]))
                    return false;
            return true;
        }

        void Merge(double unit, MeshReader reader)
        {
            double3 boxMin = double.PositiveInfinity, boxMax = double.NegativeInfinity;
            int vertexCount = 0, triangleCount = 0;
            foreach (var part in _parts)
            {
                part.Source.Bound(part.InFrame, out var centre, out var half);
                boxMin = math.min(boxMin, centre - half);
                boxMax = math.max(boxMax, centre + half);
                vertexCount += part.Source.VertexCount;
                triangleCount += part.Source.TriangleCount;
            }
            _vertexFrame = new VertexFrame((boxMax + boxMin) / 2, (boxMax - boxMin) / 2, unit);
            var into = _vertexFrame.Into;
            var vertices = new float3[vertexCount];
            var indices = new int[3 * triangleCount];
            vertexCount = 0;
            int indexCount = 0;
            foreach (var part in _parts)
                reader.Append(part.Source.Mesh, into * part.InFrame, vertices, ref vertexCount,
                    indices, ref indexCount);
            _mesh = new TriangleMesh(vertices, indices);
            (_parts, _merged) = (_merged, _parts);
        }

        // The contribution of an object to the merged vertices.
        struct Part
        {
            public MeshSource Source;
            public int Version;
            public Affine InFrame;

            public bool Equals(in Part other) =>
                Source == other.Source && Version == other.Version && InFrame.Equals(other.InFrame);
        }
    }
}
