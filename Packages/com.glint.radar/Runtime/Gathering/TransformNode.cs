using System;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// A transform at or above a traced object, the radar or its receiver, in the state of the gather.
    /// Transforms are composed in double from local position, rotation and scale:
    /// Unity's float32 world matrices lose centimetres far from the origin.
    /// </summary>
    sealed class TransformNode
    {
        TransformNode _frame;
        Affine _local, _inFrame;
        Vector3 _position, _scale;
        Quaternion _rotation;
        int _depth;

        /// <summary>Null for the world.</summary>
        public TransformNode Parent { get; private set; }

        /// <summary>Whether it is known to move.</summary>
        public bool Moves { get; private set; }

        /// <summary>The nearest transform at or above it that is known to move; else the world.</summary>
        public TransformNode Mover { get; private set; }

        /// <summary>The objects whose nearest mover it is; null before they are collected.</summary>
        public RigidGroup Group { get; set; }

        /// <summary>Whether it is at or below the transform of the scene's origin.</summary>
        public bool IsInScene { get; private set; }

        /// <summary>Transform from this node's coordinates to the scene's; only for one in the scene.</summary>
        public Affine ToScene { get; private set; }

        /// <summary>The mesh of its object in the last gather; null if none.</summary>
        public MeshSource Source { get; private set; }

        /// <summary>True if the object had another mesh before.</summary>
        public bool SwapsMesh { get; private set; }

        /// <summary>True if its object is in this gather.</summary>
        public bool IsTaken { get; set; }

        /// <summary>Index of its object in this gather.</summary>
        public int ObjectNumber { get; set; }

        /// <summary>Material of its object where no <see cref="RadarSurface"/> gives one.</summary>
        public SurfaceMaterial OwnMaterial { get; set; }

        // Its own components.
        RadarSurface[] _surfaces;

        /// <summary>
        /// The surface of the whole object, from the nearest transform at or above it that has one; null if none has.
        /// </summary>
        RadarSurface _surface;

        // Of the nearest transform at or above it that has one: what says how it moves.
        RadarMotion _motion;
        Rigidbody _rigidbody;
        TransformNode _motionNode;

        /// <summary>How it moves, in a scene with its origin at a point of the world.</summary>
        public RigidMotion MotionIn(double3 origin)
        {
            if (_motion != null)
                return new RigidMotion
                {
                    Velocity = (float3)_motion.Velocity, AngularVelocity = math.radians((float3)_motion.TurnRates),
                    Pivot = _motionNode.ToWorld().Origin - origin
                };
            return _rigidbody == null
                ? default
                : new RigidMotion
                {
                    Velocity = (float3)_rigidbody.linearVelocity, AngularVelocity = (float3)_rigidbody.angularVelocity,
                    Pivot = (float3)_rigidbody.worldCenterOfMass - origin
                };
        }

        /// <summary>Refuses a surface of its object whose material is gone.</summary>
        /// <exception cref="GlintException">A material is gone.</exception>
        public void CheckMaterials()
        {
            var lost = Array.Find(_surfaces, own => own.HasLostMaterial)
                ?? (_surface != null && _surface.HasLostMaterial ? _surface : null);
            if (lost != null)
                throw new GlintException($"RadarSurface of '{lost.name}' refers to a radar material that is gone: assign "
                    + "another one, or None for a perfect conductor");
        }

        /// <summary>A surface of a submesh that its object lacks; null: none.</summary>
        /// <param name="submeshes">Number of submeshes of its mesh.</param>
        public RadarSurface SurfaceBeyond(int submeshes)
        {
            foreach (var own in _surfaces)
                if (own.Submesh >= submeshes)
                    return own;
            return null;
        }

        /// <summary>The material of a submesh of its object.</summary>
        public SurfaceMaterial MaterialOf(int submesh)
        {
            var surface = Array.Find(_surfaces, own => own.Submesh == submesh) ?? _surface;
            if (surface == null)
                return OwnMaterial;
            return surface.Material == null ? SurfaceMaterial.PerfectConductor : surface.Material.ToSurface();
        }

        /// <summary>The parent of roots.</summary>
        public static TransformNode World()
        {
            var world = new TransformNode { _local = Affine.Identity };
            world.Mover = world;
            return world;
        }

        /// <summary>
        /// Updates the state. A transform that has changed counts as moving from now on.
        /// </summary>
        /// <param name="moves">True if motion was announced.</param>
        public void Update(Transform transform, TransformNode parent, bool moves)
        {
            transform.GetLocalPositionAndRotation(out var position, out var rotation);
            var scale = transform.localScale;
            // Compared exactly: == of Unity's vectors is approximate.
            bool isUnmoved = position.Equals(_position) && rotation.Equals(_rotation) && scale.Equals(_scale);
            (_motion, _rigidbody, _motionNode) = (parent._motion, parent._rigidbody, parent._motionNode);
            bool hasMotion = transform.TryGetComponent<RadarMotion>(out var motion)
                | transform.TryGetComponent<Rigidbody>(out var body);
            if (hasMotion)
                (_motion, _rigidbody, _motionNode) = (motion, body, this);
            Moves |= moves || hasMotion || Parent == parent && !isUnmoved;
            Mover = Moves ? this : parent.Mover;
            (Parent, _position, _rotation, _scale) = (parent, position, rotation, scale);
            _depth = parent._depth + 1;
            _local = Local((float3)position, (float3)scale);
            (_frame, Group, IsTaken, OwnMaterial) = (null, null, false, SurfaceMaterial.PerfectConductor);
            _surfaces = transform.TryGetComponent<RadarSurface>(out _)
                ? transform.GetComponents<RadarSurface>()
                : Array.Empty<RadarSurface>();
            _surface = Array.Find(_surfaces, own => own.Submesh == RadarSurface.AllSubmeshes) ?? parent._surface;
        }

        public void SetSource(MeshSource source)
        {
            SwapsMesh |= Source != null && Source != source;
            Source = source;
        }

        /// <summary>The nearest common ancestor, which may be one of them; else the world.</summary>
        public static TransformNode Common(TransformNode first, TransformNode other)
        {
            while (first != other)
            {
                if (first._depth > other._depth)
                    first = first.Parent;
                else
                    other = other.Parent;
            }
            return first;
        }

        /// <summary>Transform from this node's coordinates to the world's.</summary>
        public Affine ToWorld() => Parent == null ? _local : Parent.ToWorld() * _local;

        /// <summary>Composes <see cref="ToScene"/>. Parents come before their children.</summary>
        /// <param name="centre">
        /// The transform of the scene's origin: positions of it and of transforms above it do not count.
        /// </param>
        public void Compose(TransformNode centre)
        {
            IsInScene = this == centre || Parent != null && Parent.IsInScene;
            if (this == centre)
                ToScene = WithoutShift(ToWorld());
            else if (IsInScene)
                ToScene = Parent.ToScene * _local;
        }

        /// <summary>
        /// From this transform's coordinates to the scene's without its own scale, for a frame, whose vertices include
        /// the scale.
        /// </summary>
        public Affine FrameToScene()
        {
            var unscaled = Local((float3)_position, 1);
            return Parent.IsInScene ? Parent.ToScene * unscaled : WithoutShift(Parent.ToWorld() * unscaled);
        }

        /// <summary>
        /// From this transform's coordinates to those of a frame at or above it, without the frame's own scale.
        /// </summary>
        public Affine InFrame(TransformNode frame)
        {
            if (_frame != frame)
                (_frame, _inFrame) = (frame, this == frame ? Scaled((float3)_scale) : Parent.InFrame(frame) * _local);
            return _inFrame;
        }

        /// <summary>
        /// Pose in the scene; the columns are right, up and forward as in Unity: unit vectors, since rotations are
        /// multiplied without scales.
        /// </summary>
        public Affine Pose()
        {
            var rotation = Rotation();
            for (var above = Parent; above.Parent != null; above = above.Parent)
                rotation = above.Rotation() * Mirrored(rotation, above._scale);
            rotation.Origin = ToScene.Origin;
            return rotation;
        }

        Affine Rotation() => Local(0, 1);

        Affine Local(double3 position, double3 scale) =>
            Affine.FromTransform(position, new double4(_rotation.x, _rotation.y, _rotation.z, _rotation.w), scale);

        // Below a mirrored transform a rotation is mirrored too: the signs of the scale take part.
        static Affine Mirrored(in Affine rotation, Vector3 scale)
        {
            var signs = new double3(scale.x < 0 ? -1 : 1, scale.y < 0 ? -1 : 1, scale.z < 0 ? -1 : 1);
            return Scaled(signs) * rotation * Scaled(signs);
        }

        static Affine Scaled(double3 scale) => new Affine
        {
            X = new double3(scale.x, 0, 0), Y = new double3(0, scale.y, 0), Z = new double3(0, 0, scale.z)
        };

        static Affine WithoutShift(Affine transform)
        {
            transform.Origin = 0;
            return transform;
        }
    }
}
