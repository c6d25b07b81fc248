using System.Collections.Generic;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The transforms of a scene from the traced objects, the radar and its receiver up to the roots.
    /// </summary>
    sealed class TransformTree
    {
        readonly FrameCache<Transform, TransformNode> _nodes = new FrameCache<Transform, TransformNode>();
        readonly HashSet<Transform> _expected = new HashSet<Transform>();
        readonly List<TransformNode> _visited = new List<TransformNode>();

        /// <summary>The parent of roots.</summary>
        public TransformNode World { get; } = TransformNode.World();

        /// <summary>Announces that a transform will move.</summary>
        /// <returns>False if it was announced already.</returns>
        public bool ExpectMotion(Transform transform) => _expected.Add(transform);

        /// <summary>
        /// Withdraws <see cref="ExpectMotion"/>. A transform that has moved counts as moving until <see
        /// cref="Forget"/>.
        /// </summary>
        public void ExpectNoMotion(Transform transform) => _expected.Remove(transform);

        public void Begin()
        {
            _expected.RemoveWhere(transform => transform == null);
            _nodes.Begin();
            _visited.Clear();
            _visited.Add(World);
            World.Group = null;
        }

        public TransformNode Visit(Transform transform)
        {
            var node = _nodes.Get(transform, out bool first);
            if (first)
            {
                var parent = transform.parent;
                node.Update(transform, parent == null ? World : Visit(parent), _expected.Contains(transform));
                _visited.Add(node);
            }
            return node;
        }

        /// <summary>
        /// Composes the transforms of all visited nodes in a scene with its origin at <paramref name="centre"/>.
        /// </summary>
        public void Compose(TransformNode centre)
        {
            foreach (var node in _visited) // parents first
                node.Compose(centre);
        }

        public void End() => _nodes.End();

        /// <summary>Releases everything except announcements of motion.</summary>
        public void Forget()
        {
            _nodes.Clear();
            _visited.Clear();
        }
    }
}
