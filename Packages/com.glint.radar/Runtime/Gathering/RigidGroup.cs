using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Objects with the same nearest moving transform above them: they keep still relative to each other.
    /// Their frame stands at the nearest transform above them all, so that nothing in it changes when that transform,
    /// or one above it, moves.
    /// </summary>
    sealed class RigidGroup
    {
        // Objects farther apart than so many metres are not merged: steps of float32 are 0.06 mm there.
        const double Reach = 1000;

        // Objects at distances of half the reach stand on borders, to and fro by rounding; borders are a hair off.
        const double OffBorder = 1e-6;

        TransformNode _common, _frame;
        double3? _anchor;

        /// <summary>From the frame's coordinates to the scene's.</summary>
        public Affine ToScene { get; private set; }

        /// <summary>A length of 1 in the frame is about so many metres; a power of two.</summary>
        public double Unit { get; private set; }

        public void Add(TransformNode node) => _common = _common == null ? node : TransformNode.Common(_common, node);

        /// <summary>Chooses the frame, when all objects are there and transforms are composed.</summary>
        public void ChooseFrame()
        {
            // A frame that squeezes is none; the scene's own always is one.
            for (_frame = _common; _frame.IsInScene && _frame.Parent != null; _frame = _frame.Parent)
            {
                ToScene = _frame.FrameToScene();
                Unit = TransformMath.Unit(ToScene);
                if (TransformMath.Conditioning(ToScene)
                    >= (_frame.Moves ? TransformMath.MinConditioning : TransformMath.GoodConditioning))
                    return;
            }
            (_frame, ToScene, Unit) = (null, Affine.Identity, 1);
        }

        /// <summary>From the coordinates of one of the objects to the frame's.</summary>
        public Affine Into(TransformNode node) => _frame == null ? node.ToScene : node.InFrame(_frame);

        /// <summary>Objects of the same cell are near each other.</summary>
        public int3 Cell(TransformNode node)
        {
            double3 centre = Into(node).Point(node.Source.Centre);
            _anchor ??= centre;
            return (int3)math.floor((centre - _anchor.Value) * (Unit / Reach) + (0.5 + OffBorder));
        }
    }
}
