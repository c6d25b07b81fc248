using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// A gathered scene whose instances follow their objects from frame to frame. Meshes are read only when it is
    /// gathered. It allocates nothing while it follows.
    /// </summary>
    sealed class FollowedScene
    {
        // Objects that a frame compares with what was gathered.
        const int ChecksAFrame = 32;

        // Metres, and part of an axis, by which objects of one instance may move against each other: float32 matrices of
        // objects 20 km from the origin round by 2 mm.
        const double MinShift = 0.02, MinTurn = 1e-3;

        readonly SceneGatherer _gatherer = new SceneGatherer { LeavesOutSeas = true };
        readonly List<FollowedObject> _objects = new List<FollowedObject>();
        FollowedInstance[] _instances;
        int _next;

        /// <summary>The scene; its instances are where their objects were in the last frame.</summary>
        public RadarScene Scene { get; private set; }

        /// <summary>Of each instance, whether it belongs to the own ship.</summary>
        public bool[] IsOwnShip { get; private set; }

        /// <summary>Objects that are not traced and why.</summary>
        public IReadOnlyList<string> Warnings => _gatherer.Warnings;

        /// <summary>Gathers all meshes on some layers, except those of seas.</summary>
        /// <param name="ownShip">It and all below it is the own ship.</param>
        /// <exception cref="GlintException">A mesh cannot be traced; the message names it and the remedy.</exception>
        public void Gather(LayerMask layers, Transform ownShip)
        {
            // Ships are not merged with what stands still.
            _gatherer.ExpectMotion(ownShip);
            foreach (var ship in SceneSearch.FindEnabled<Underway>())
                _gatherer.ExpectMotion(ship.transform);
            var gathered = _gatherer.Gather(layers, new Transform[0], null);
            // A copy, because the gatherer compares with its own.
            Scene = new RadarScene((MeshInstance[])gathered.Instances.Clone()) { Surfaces = gathered.Surfaces };
            _instances = new FollowedInstance[Scene.Instances.Length];
            IsOwnShip = new bool[_instances.Length];
            _objects.Clear();
            _next = 0;
            for (int i = 0; i < _instances.Length; i++)
            {
                var ranges = Scene.Instances[i].Ranges;
                var leader = _gatherer.ObjectAt(ranges[0].Object);
                _instances[i] = new FollowedInstance(leader, Scene.Instances[i].ToWorld);
                IsOwnShip[i] = leader.IsChildOf(ownShip);
                foreach (var range in ranges)
                    if (_objects.Count == 0 || _objects[_objects.Count - 1].Number != range.Object)
                        _objects.Add(new FollowedObject(range.Object, i, _gatherer.ObjectAt(range.Object), leader));
            }
        }

        /// <summary>Takes the instances to where their objects are.</summary>
        /// <param name="hasMoved">Whether an instance has moved.</param>
        /// <returns>False if the scene must be gathered again: an object has gone, was scaled, or has left its group.</returns>
        public bool Follow(out bool hasMoved)
        {
            hasMoved = false;
            for (int i = 0; i < _instances.Length; i++)
            {
                if (_instances[i].Leader == null)
                    return false;
                if (!_instances[i].HasMoved(out var toWorld))
                    continue;
                if (_instances[i].HasScaled(toWorld))
                    return false;
                Scene.Instances[i].ToWorld = toWorld;
                hasMoved = true;
            }
            for (int i = 0; i < ChecksAFrame && i < _objects.Count; i++)
            {
                _next = (_next + 1) % _objects.Count;
                if (!_objects[_next].IsAsGathered(_instances[_objects[_next].Instance].Leader))
                    return false;
            }
            return true;
        }

        static Affine AffineOf(in Matrix4x4 m) => new Affine
        {
            X = new double3(m.m00, m.m10, m.m20), Y = new double3(m.m01, m.m11, m.m21),
            Z = new double3(m.m02, m.m12, m.m22), Origin = new double3(m.m03, m.m13, m.m23)
        };

        // An instance is rigidly tied to its first object.
        struct FollowedInstance
        {
            readonly Affine _fromLeader;
            readonly double3 _scale;
            Matrix4x4 _matrix;

            public FollowedInstance(Transform leader, in Affine toWorld)
            {
                Leader = leader;
                _matrix = leader.localToWorldMatrix;
                _fromLeader = AffineOf(_matrix).Inverse() * toWorld;
                _scale = ScaleOf(toWorld);
            }

            public Transform Leader { get; }

            // Points on surfaces hold areas.
            public bool HasScaled(in Affine toWorld) =>
                math.any(math.abs(ScaleOf(toWorld) - _scale) > MinTurn * _scale);

            static double3 ScaleOf(in Affine toWorld) =>
                new double3(math.length(toWorld.X), math.length(toWorld.Y), math.length(toWorld.Z));

            public bool HasMoved(out Affine toWorld)
            {
                var matrix = Leader.localToWorldMatrix;
                // Compared exactly: == of Unity's matrices is approximate.
                bool hasMoved = !matrix.Equals(_matrix);
                _matrix = matrix;
                toWorld = hasMoved ? AffineOf(matrix) * _fromLeader : default;
                // Not after an object that had no size when the scene was gathered.
                return hasMoved && !double.IsNaN(toWorld.Determinant);
            }
        }

        readonly struct FollowedObject
        {
            readonly Transform _transform;
            readonly Renderer _renderer;
            readonly MeshFilter _filter;
            readonly Mesh _mesh;
            readonly Affine _fromLeader;

            public FollowedObject(int number, int instance, Transform transform, Transform leader)
            {
                (Number, Instance, _transform) = (number, instance, transform);
                _renderer = transform.GetComponent<Renderer>();
                _filter = transform.GetComponent<MeshFilter>();
                _mesh = _filter.sharedMesh;
                _fromLeader = FromLeader(transform, leader);
            }

            public int Number { get; }

            public int Instance { get; }

            public bool IsAsGathered(Transform leader)
            {
                if (_renderer == null || _filter == null || !_renderer.enabled
                    || !_renderer.gameObject.activeInHierarchy || _filter.sharedMesh != _mesh)
                    return false;
                if (_transform == leader)
                    return true;
                var from = FromLeader(_transform, leader);
                var shift = AffineOf(leader.localToWorldMatrix).Vector(from.Origin - _fromLeader.Origin);
                // Not of numbers that are not finite: gathering again would not help.
                return !(math.length(shift) >= MinShift || IsFar(from.X, _fromLeader.X)
                    || IsFar(from.Y, _fromLeader.Y) || IsFar(from.Z, _fromLeader.Z));
            }

            static Affine FromLeader(Transform transform, Transform leader) =>
                AffineOf(leader.localToWorldMatrix).Inverse() * AffineOf(transform.localToWorldMatrix);

            static bool IsFar(double3 axis, double3 other) =>
                math.length(axis - other) >= MinTurn * math.length(other) + double.Epsilon;
        }
    }
}
