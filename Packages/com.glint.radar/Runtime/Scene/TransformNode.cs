using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// A transform at or above a traced object, as the gather found it. Transforms are composed in double from local position, rotation and scale:
    /// Unity's float32 world matrices lose centimetres far from the origin.
    /// </summary>
    sealed class TransformNode
    {
        // A frame that squeezes more than this is none: the rays traced in it would lose too many digits.
        const double LeastEvenness = 1e-3;

        TransformNode _parent;
        Vector3 _position, _scale;
        Quaternion _rotation;
        bool _moves;

        /// <summary>From this transform's coordinates to the world.</summary>
        public Affine ToWorld { get; private set; }

        /// <summary>The nearest at or above that is known to move; the world if none.</summary>
        public TransformNode Frame { get; private set; }

        /// <summary>From this transform's coordinates to those of <see cref="Frame"/>.</summary>
        public Affine InFrame { get; private set; }

        /// <summary>Of one that is a frame: from the frame's coordinates to the world. The transform's own scale is not in it, the vertices carry that.</summary>
        public Affine FrameToWorld { get; private set; }

        /// <summary>Of one that is a frame: a length of 1 in it is about so many metres; a power of two.</summary>
        public double FrameUnit { get; private set; }

        /// <summary>Of one that is a frame: the middle of the first object in it, in its coordinates.</summary>
        public double3? Anchor { get; set; }

        /// <summary>The mesh that its object had in the gather before; null if none.</summary>
        public MeshSource Source { get; private set; }

        /// <summary>True when the object has had another mesh before.</summary>
        public bool SwapsMesh { get; private set; }

        /// <summary>True when its object is among those of this gather.</summary>
        public bool IsTaken { get; set; }

        /// <summary>The parent of roots.</summary>
        public static TransformNode World()
        {
            var world = new TransformNode { ToWorld = Affine.Identity, InFrame = Affine.Identity, FrameToWorld = Affine.Identity, FrameUnit = 1 };
            world.Frame = world;
            return world;
        }

        /// <summary>Takes the transform as it stands now. One that does not stand as it did moves from now on.</summary>
        /// <param name="moves">True to count it as moving already.</param>
        public void Update(Transform transform, TransformNode parent, bool moves)
        {
            transform.GetLocalPositionAndRotation(out var position, out var rotation);
            var scale = transform.localScale;
            // Compared bit by bit: == of Unity's vectors takes near values for equal.
            bool stands = position.Equals(_position) && rotation.Equals(_rotation) && scale.Equals(_scale);
            _moves |= moves || _parent == parent && !stands;
            (_parent, _position, _rotation, _scale) = (parent, position, rotation, scale);
            (IsTaken, Anchor) = (false, null);
            Compose();
        }

        public void SetSource(MeshSource source)
        {
            SwapsMesh |= Source != null && Source != source;
            Source = source;
        }

        void Compose()
        {
            var rotation = new double4(_rotation.x, _rotation.y, _rotation.z, _rotation.w);
            double3 position = (float3)_position, scale = (float3)_scale;
            var local = Affine.FromTransform(position, rotation, scale);
            ToWorld = _parent.ToWorld * local;
            FrameToWorld = _parent.ToWorld * Affine.FromTransform(position, rotation, 1);
            if (_moves && Shape.Evenness(FrameToWorld) >= LeastEvenness)
            {
                Frame = this;
                FrameUnit = Shape.Unit(FrameToWorld);
                InFrame = new Affine { X = new double3(scale.x, 0, 0), Y = new double3(0, scale.y, 0), Z = new double3(0, 0, scale.z) };
            }
            else
            {
                Frame = _parent.Frame;
                InFrame = _parent.InFrame * local;
            }
        }
    }
}
