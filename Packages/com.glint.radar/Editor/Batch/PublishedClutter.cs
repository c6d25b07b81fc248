using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>All published models of sea clutter: the formulas, and the table that the package carries.</summary>
    public static class PublishedClutter
    {
        const string Path = PublishedTable.Folder + "/nathanson_sea_reflectivity.csv";

        /// <summary>The models in the order of options and plots.</summary>
        /// <exception cref="GlintException">The table is missing or malformed.</exception>
        public static IReadOnlyList<ClutterModel> Models => ClutterModel.Formulas.Append(Nathanson()).ToArray();

        /// <summary>The model of a level; null for physics.</summary>
        /// <exception cref="GlintException">The table is missing or malformed.</exception>
        public static ClutterModel Of(ClutterLevel level) =>
            level == ClutterLevel.Nathanson ? Nathanson() : ClutterModel.Of(level);

        static NathansonTable Nathanson()
        {
            var asset = AssetDatabase.LoadAssetAtPath<TextAsset>(Path);
            return asset != null
                ? new NathansonTable(asset.text, Path)
                : throw new GlintException($"{Path}: the table of sea reflectivities is missing: restore the package");
        }
    }
}
