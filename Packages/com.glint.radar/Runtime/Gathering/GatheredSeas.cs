using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>The seas of a gather whose clutter is on, and their tiles.</summary>
    sealed class GatheredSeas
    {
        readonly Dictionary<Sea, GatheredSea> _seas = new Dictionary<Sea, GatheredSea>();
        readonly Dictionary<TransformNode, GatheredSea> _ofTiles = new Dictionary<TransformNode, GatheredSea>();

        public void Clear()
        {
            _seas.Clear();
            _ofTiles.Clear();
        }

        /// <summary>Finds the sea of an object that may be a tile, and gives the tile its water.</summary>
        /// <exception cref="GlintException">The sea's clutter is refused; the message names the sea.</exception>
        public void Visit(TransformNode node, Renderer renderer)
        {
            if (!renderer.TryGetComponent<SeaTile>(out _) || renderer.transform.parent == null
                || !renderer.transform.parent.TryGetComponent<Sea>(out var sea) || !sea.Clutter.IsOn)
                return;
            if (!_seas.TryGetValue(sea, out var gathered))
                _seas.Add(sea, gathered = new GatheredSea(sea));
            node.OwnMaterial = gathered.Clutter.Surface;
            _ofTiles.Add(node, gathered);
        }

        /// <summary>Whether an object is a tile of one of the seas.</summary>
        public bool HasTile(TransformNode node) => _ofTiles.ContainsKey(node);

        /// <summary>Adds a tile that is an instance of its own.</summary>
        /// <param name="instance">Its place in the scene.</param>
        /// <exception cref="GlintException">The mesh of the tile is not that of the sea's settings.</exception>
        public void Add(TransformNode node, Transform tile, int instance)
        {
            var gathered = _ofTiles[node];
            int cells = gathered.Clutter.LongWaves.Settings.Cells, triangles = 2 * cells * cells;
            if (node.Source.TriangleCount != triangles)
                throw new GlintException($"Sea of '{gathered.Sea.name}': its tile has {node.Source.TriangleCount} "
                    + $"triangles, and its settings make {triangles}: store the snapshot again with glint sea, "
                    + "or turn clutter off");
            gathered.Tiles.Add(new SeaTileInstance(instance, gathered.Sea.NumberOf(tile)));
        }

        /// <summary>The seas that have tiles in the scene.</summary>
        public IReadOnlyList<RadarSea> ToSeas() => _seas.Values.Where(sea => sea.Tiles.Count > 0)
            .Select(sea => new RadarSea(sea.Clutter, sea.Tiles)).ToArray();

        /// <summary>What is doubtful of the seas, a line each.</summary>
        public IEnumerable<string> Warnings => _seas.Values.Where(it => it.Clutter.ShortWaves.StepWarning != null)
            .Select(it => $"Sea of '{it.Sea.name}': {it.Clutter.ShortWaves.StepWarning}");

        sealed class GatheredSea
        {
            public readonly Sea Sea;
            public readonly SeaClutter Clutter;
            public readonly List<SeaTileInstance> Tiles = new List<SeaTileInstance>();

            public GatheredSea(Sea sea) => (Sea, Clutter) = (sea, sea.CurrentClutter());
        }
    }
}
