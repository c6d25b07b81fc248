using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Objects with the same nearest moving transform above them, which do not move relative to each other. Their frame
    /// is the nearest transform above all of them, so that nothing in it changes when that transform, or one above it,
    /// moves.
    /// </summary>
    sealed class RigidGroup
    {
        // Maximum distance of merged objects, metres: float32 steps are 0.06 mm there.
        const double Reach = 1000;

        // Offset of cell borders, so that objects at multiples of half the reach are not on a border.
        const double OffBorder = 1e-6;

        TransformNode _common, _frame;
        double3? _anchor;

        /// <summary>Transform from the frame's coordinates to the scene's.</summary>
        public Affine ToScene { get; private set; }

        /// <summary>Approximate metres per unit of the frame; a power of two.</summary>
        public double Unit { get; private set; }

        public void Add(TransformNode node) => _common = _common == null ? node : TransformNode.Common(_common, node);

        /// <summary>Chooses the frame, after all objects are added and transforms are composed.</summary>
        public void ChooseFrame()
        {
            // A badly conditioned transform cannot be the frame; the scene's own always can.
            for (_frame = _common; _frame.IsInScene && _frame.Parent != null; _frame = _frame.Parent)
            {
                ToScene = _frame.FrameToScene();
                Unit = TransformMath.Unit(ToScene);
                if (TransformMath.Conditioning(ToScene)
                    >= (_frame.Moves ? TransformMath.MinConditioning : TransformMath.SimilarConditioning))
                    return;
            }
            (_frame, ToScene, Unit) = (null, Affine.Identity, 1);
        }

        /// <summary>Transform from the coordinates of an object to the frame's.</summary>
        public Affine Into(TransformNode node) => _frame == null ? node.ToScene : node.InFrame(_frame);

        /// <summary>Cell of an object; objects of one cell are near each other.</summary>
        public int3 Cell(TransformNode node)
        {
            double3 centre = Into(node).Point(node.Source.Centre);
            _anchor ??= centre;
            return (int3)math.floor((centre - _anchor.Value) * (Unit / Reach) + (0.5 + OffBorder));
        }
    }
}
