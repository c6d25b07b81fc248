using System.Collections.Generic;
using UnityEngine;

namespace Glint
{
    /// <summary>The transforms of a scene from the traced objects up to the roots.</summary>
    sealed class TransformTree
    {
        readonly Kept<Transform, TransformNode> _nodes = new Kept<Transform, TransformNode>();
        readonly HashSet<Transform> _expected = new HashSet<Transform>();
        readonly TransformNode _world = TransformNode.World();

        /// <summary>Counts a transform as moving before it has moved.</summary>
        public void ExpectMotion(Transform transform) => _expected.Add(transform);

        public void Begin()
        {
            _expected.RemoveWhere(transform => transform == null);
            _world.Anchor = null;
            _nodes.Begin();
        }

        public TransformNode Visit(Transform transform)
        {
            var node = _nodes.Get(transform, out bool first);
            if (first)
            {
                var parent = transform.parent;
                node.Update(transform, parent == null ? _world : Visit(parent), _expected.Contains(transform));
            }
            return node;
        }

        public void End() => _nodes.End();

        /// <summary>Lets go of all but what is expected to move.</summary>
        public void Forget() => _nodes.Clear();
    }
}
