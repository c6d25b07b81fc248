using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>The tiles of a sea: adjacent objects with one mesh.</summary>
    public sealed class SeaTiles
    {
        const int MaxTiles = 100_000;

        // Neither listed, saved nor editable: the sea recreates them.
        const HideFlags Made = HideFlags.HideInHierarchy | HideFlags.DontSaveInEditor | HideFlags.DontSaveInBuild
            | HideFlags.NotEditable;

        readonly List<MeshFilter> _tiles = new List<MeshFilter>();

        /// <summary>Number of visible tiles.</summary>
        public int Shown { get; private set; }

        /// <summary>
        /// Covers an extent with copies of a tile; existing objects are reused, surplus ones are hidden.
        /// </summary>
        /// <param name="parent">Parent of the tiles.</param>
        /// <param name="size">Side of the tile in metres.</param>
        /// <param name="extent">Minimum extent along the parent's X and Z, metres.</param>
        /// <param name="centre">
        /// Centre of the extent in the parent's coordinates; it is rounded to whole tiles.
        /// </param>
        /// <param name="subject">Name of the sea, for messages.</param>
        /// <exception cref="GlintException">The extent takes too many tiles, or none.</exception>
        public void Rebuild(Transform parent, Mesh mesh, Material material, double size, Vector2 extent,
            Vector3 centre, string subject)
        {
            int across = Count(extent.x, size, subject), along = Count(extent.y, size, subject);
            if ((long)across * along > MaxTiles)
                throw new GlintException(FormattableString.Invariant(
                    $"{subject}: an extent of {extent.x} x {extent.y} m takes {(long)across * along} tiles of {size} m, and {MaxTiles} is the limit: use larger tiles or a smaller extent"));
            Find(parent);
            // Moved by whole tiles, so that the waves remain in place.
            var whole = new Vector3((float)(size * Math.Round(centre.x / size)), 0,
                (float)(size * Math.Round(centre.z / size)));
            for (int i = 0; i < across * along; i++)
            {
                if (i == _tiles.Count)
                    _tiles.Add(MakeTile(parent));
                var tile = _tiles[i];
                tile.gameObject.layer = parent.gameObject.layer;
                tile.transform.localPosition =
                    PositionOf(i % across, i / across, new int2(across, along), size) + whole;
                if (tile.sharedMesh != mesh)
                    tile.sharedMesh = mesh;
                var renderer = tile.GetComponent<MeshRenderer>();
                renderer.enabled = true;
                if (material != null)
                    renderer.sharedMaterial = material;
            }
            Hide(across * along);
        }

        /// <summary>Whether the tiles are drawn. Their renderers stay enabled, so that they are traced.</summary>
        public void Draw(bool draws)
        {
            foreach (var tile in _tiles)
                tile.GetComponent<MeshRenderer>().forceRenderingOff = !draws;
        }

        /// <summary>Position of a tile in a grid of tiles centred on the origin.</summary>
        public static Vector3 PositionOf(int x, int z, int2 tiles, double size) =>
            new Vector3((float)(size * (x - (tiles.x - 1) / 2.0)), 0, (float)(size * (z - (tiles.y - 1) / 2.0)));

        /// <summary>
        /// Hides all tiles. They are not destroyed: Unity forbids that while a parent is activated or deactivated.
        /// </summary>
        public void Hide(Transform parent)
        {
            Find(parent);
            Hide(0);
        }

        void Hide(int first)
        {
            Shown = first;
            for (int i = first; i < _tiles.Count; i++)
                _tiles[i].GetComponent<MeshRenderer>().enabled = false;
        }

        // Reuses tiles from before a reload of the scripts, and those copied with the parent.
        void Find(Transform parent)
        {
            _tiles.Clear();
            for (int i = 0; i < parent.childCount; i++)
                if (parent.GetChild(i).TryGetComponent<SeaTile>(out var tile))
                    _tiles.Add(tile.GetComponent<MeshFilter>());
        }

        static int Count(float extent, double size, string subject)
        {
            if (!(extent > 0) || float.IsInfinity(extent))
                throw new GlintException(FormattableString.Invariant(
                    $"{subject}: its extent has a side of {extent} m: give both sides in metres, above 0"));
            // Tolerates the rounding of an extent of whole tiles.
            return (int)Math.Min(int.MaxValue / 2, Math.Ceiling(extent / size - 1e-6));
        }

        static MeshFilter MakeTile(Transform parent)
        {
            var tile = new GameObject("Tile", typeof(MeshFilter), typeof(MeshRenderer), typeof(SeaTile));
            tile.hideFlags = tile.transform.hideFlags = Made; // before it gets a parent, which would count as changed
            tile.transform.SetParent(parent, false);
            return tile.GetComponent<MeshFilter>();
        }
    }
}
