using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Glint.Core;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>Cross sections over an angle that others computed (README.md beside this file).</summary>
    public static class PublishedCrossSections
    {
        /// <summary>The rows of a table, in ascending angle in degrees; VV and HH in dBsm.</summary>
        /// <param name="name">Name of the file without extension.</param>
        /// <exception cref="GlintException">It does not exist.</exception>
        public static IReadOnlyList<(double Degrees, double VV, double HH)> Read(string name)
        {
            string path = $"{PublishedTable.Folder}/{name}.csv";
            var asset = AssetDatabase.LoadAssetAtPath<TextAsset>(path);
            if (asset == null)
                throw new GlintException($"{path}: the published table is missing: restore the package");
            return asset.text.Split(new[] { '\n', '\r' }, StringSplitOptions.RemoveEmptyEntries).Skip(1).Select(line =>
            {
                var cells = Array.ConvertAll(line.Split(','), cell => double.Parse(cell, CultureInfo.InvariantCulture));
                return (cells[0], cells[1], cells[2]);
            }).ToArray();
        }
    }
}
