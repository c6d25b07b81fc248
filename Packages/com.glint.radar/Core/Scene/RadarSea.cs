using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A sea of the scene with a diffuse echo. Its tiles are instances of one mesh.</summary>
    public sealed class RadarSea : IEquatable<RadarSea>
    {
        /// <summary>A sea.</summary>
        /// <param name="clutter">Its echo.</param>
        /// <param name="tiles">Its tiles; kept, not copied.</param>
        public RadarSea(SeaClutter clutter, IReadOnlyList<SeaTileInstance> tiles) =>
            (Clutter, Tiles) = (clutter, tiles);

        /// <summary>Its echo: that of the triangles of each tile, in their order.</summary>
        public SeaClutter Clutter { get; }

        /// <summary>Its tiles.</summary>
        public IReadOnlyList<SeaTileInstance> Tiles { get; }

        /// <summary>Whether both have the same echo and the same tiles.</summary>
        public bool Equals(RadarSea other) =>
            other != null && Clutter == other.Clutter && Tiles.SequenceEqual(other.Tiles);

        /// <inheritdoc/>
        public override bool Equals(object other) => Equals(other as RadarSea);

        /// <inheritdoc/>
        public override int GetHashCode() => Clutter.GetHashCode();
    }

    /// <summary>A tile of a <see cref="RadarSea"/>.</summary>
    public readonly struct SeaTileInstance : IEquatable<SeaTileInstance>
    {
        /// <summary>A tile.</summary>
        public SeaTileInstance(int instance, int2 number) => (Instance, Number) = (instance, number);

        /// <summary>Place in <see cref="RadarScene.Instances"/>.</summary>
        public int Instance { get; }

        /// <summary>
        /// Position of the tile in the sea's own frame, in tiles: the same wherever the centre of the sea is, so that
        /// it can seed the speckle.
        /// </summary>
        public int2 Number { get; }

        /// <inheritdoc/>
        public bool Equals(SeaTileInstance other) => Instance == other.Instance && math.all(Number == other.Number);

        /// <inheritdoc/>
        public override bool Equals(object other) => other is SeaTileInstance tile && Equals(tile);

        /// <inheritdoc/>
        public override int GetHashCode() => Instance;
    }
}
