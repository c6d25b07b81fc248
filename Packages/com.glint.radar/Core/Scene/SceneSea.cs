using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A sea of a scene with a diffuse echo: instances of one tile.</summary>
    public sealed class SceneSea
    {
        /// <summary>A sea.</summary>
        /// <param name="clutter">Its echo.</param>
        /// <param name="instances">Numbers of its tiles in <see cref="RadarScene.Instances"/>, at least one.</param>
        /// <param name="tiles">
        /// Place of each tile in the sea, in tiles: the same when the sea follows its centre.
        /// </param>
        public SceneSea(SeaClutter clutter, IReadOnlyList<int> instances, IReadOnlyList<int2> tiles)
        {
            if (instances.Count == 0 || instances.Count != tiles.Count)
                throw new ArgumentException("a sea has at least one tile, and each tile a place");
            (Clutter, Instances, Tiles) = (clutter, instances, tiles);
        }

        /// <summary>The echo.</summary>
        public SeaClutter Clutter { get; }

        /// <summary>Numbers of the tiles in <see cref="RadarScene.Instances"/>.</summary>
        public IReadOnlyList<int> Instances { get; }

        /// <summary>Place of each tile in the sea, in tiles.</summary>
        public IReadOnlyList<int2> Tiles { get; }
    }
}
