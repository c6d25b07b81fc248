using System.Linq;
using Glint.Core;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>The clutter of the open scene's seas, as a command line asks for it.</summary>
    static class SceneClutter
    {
        /// <summary>
        /// Switches the clutter of all seas on or off. With clutter, a stored snapshot that stands alone is shown by a
        /// Sea.
        /// </summary>
        /// <param name="input">The scene, for messages.</param>
        /// <exception cref="GlintException">The scene has no sea, or a sea cannot have clutter.</exception>
        public static void Set(ClutterChoice choice, string input)
        {
            var alone = SceneSearch.FindEnabled<SeaSnapshot>()
                .Where(it => it.GetComponentInChildren<Sea>() == null).ToArray();
            if (choice.AppliedTo(SeaClutterSettings.Off).IsOn)
                foreach (var snapshot in alone)
                    AddSea(snapshot);
            var seas = SceneSearch.FindEnabled<Sea>();
            // A snapshot without a Sea has no clutter to switch off.
            if (seas.Length == 0 && alone.Length == 0)
                throw new GlintException($"{input}: has no sea whose clutter could be switched: leave "
                    + $"{Options.Clutter.Flag} out, or add a Sea (Glint > Sea)");
            foreach (var sea in seas)
            {
                sea.Clutter = choice.AppliedTo(sea.Clutter);
                sea.Rebuild();
            }
        }

        // Below the snapshot's own object, so that it is traced where that was.
        static void AddSea(SeaSnapshot snapshot)
        {
            foreach (var renderer in snapshot.GetComponentsInChildren<Renderer>())
                renderer.enabled = false;
            var sea = new GameObject(snapshot.name).AddComponent<Sea>();
            sea.transform.SetParent(snapshot.transform, false);
            sea.Snapshots.Add(snapshot);
            float side = (float)snapshot.Settings.TileSize;
            sea.Extent = new Vector2(side, side);
        }
    }
}
