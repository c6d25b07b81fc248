using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>The tiles of a sea: objects with one mesh, side by side.</summary>
    sealed class SeaTiles
    {
        const int MaxTiles = 100_000;

        // Seen in the Hierarchy and traced, but not saved and not to be edited: the sea makes them anew.
        const HideFlags Made = HideFlags.DontSaveInEditor | HideFlags.DontSaveInBuild | HideFlags.NotEditable;

        readonly List<MeshFilter> _tiles = new List<MeshFilter>();

        /// <summary>Tiles last laid that are not hidden.</summary>
        public int Shown { get; private set; }

        /// <summary>
        /// Shows a tile over an extent; objects that are there already are taken again, those left over are hidden.
        /// </summary>
        /// <param name="parent">Has the tiles as children.</param>
        /// <param name="size">Side of the tile in metres.</param>
        /// <param name="extent">Metres along the parent's X and Z to cover at least.</param>
        /// <param name="centre">
        /// Where the extent's middle should be, in the parent's coordinates; it is met within half a tile.
        /// </param>
        /// <param name="subject">Whose sea it is, for messages.</param>
        /// <exception cref="GlintException">The extent takes too many tiles, or none.</exception>
        public void Rebuild(Transform parent, Mesh mesh, Material material, double size, Vector2 extent,
            Vector3 centre, string subject)
        {
            int across = Count(extent.x, size, subject), along = Count(extent.y, size, subject);
            if ((long)across * along > MaxTiles)
                throw new GlintException(FormattableString.Invariant(
                    $"{subject}: an extent of {extent.x} x {extent.y} m takes {(long)across * along} tiles of {size} m, and {MaxTiles} is the limit: take larger tiles or a smaller extent"));
            Find(parent);
            // By whole tiles: the waves stay where they are.
            var whole = new Vector3((float)(size * Math.Round(centre.x / size)), 0,
                (float)(size * Math.Round(centre.z / size)));
            for (int i = 0; i < across * along; i++)
            {
                if (i == _tiles.Count)
                    _tiles.Add(MakeTile(parent));
                var tile = _tiles[i];
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

        /// <summary>Where a tile stands when so many are laid about the origin.</summary>
        public static Vector3 PositionOf(int x, int z, int2 tiles, double size) =>
            new Vector3((float)(size * (x - (tiles.x - 1) / 2.0)), 0, (float)(size * (z - (tiles.y - 1) / 2.0)));

        /// <summary>
        /// Hides all tiles. They stay: objects must not be destroyed while one above them is switched on or off.
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

        // Those of before a reload of the scripts, and those that came with a copy of the parent, are taken again.
        void Find(Transform parent)
        {
            _tiles.Clear();
            for (int i = 0; i < parent.childCount; i++)
                if (parent.GetChild(i).hideFlags == Made
                    && parent.GetChild(i).TryGetComponent<MeshFilter>(out var tile))
                    _tiles.Add(tile);
        }

        static int Count(float extent, double size, string subject)
        {
            if (!(extent > 0) || float.IsInfinity(extent))
                throw new GlintException(FormattableString.Invariant(
                    $"{subject}: its extent has a side of {extent} m: give both sides in metres, above 0"));
            // An extent of whole tiles, but for rounding, takes no more.
            return (int)Math.Min(int.MaxValue / 2, Math.Ceiling(extent / size - 1e-6));
        }

        static MeshFilter MakeTile(Transform parent)
        {
            var tile = new GameObject("Tile", typeof(MeshFilter),
                typeof(MeshRenderer))
            { layer = parent.gameObject.layer };
            tile.transform.SetParent(parent, false);
            tile.hideFlags = tile.transform.hideFlags = Made;
            return tile.GetComponent<MeshFilter>();
        }
    }
}
