using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The part of a scene that a radar lights: what is in the picture of its camera.</summary>
    public sealed class RadarFootprint
    {
        /// <summary>The footprint of a picture.</summary>
        public RadarFootprint(in RadarView view, in RadarSettings settings) =>
            (View, HalfSize) = (view, view.HalfSize(settings));

        /// <summary>The camera.</summary>
        public RadarView View { get; }

        /// <inheritdoc cref="RadarView.HalfSize"/>
        public double2 HalfSize { get; }
    }
}
