using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>A material and its source for an inspector.</summary>
    static class RadarMaterialFigures
    {
        /// <summary>Names of the library.</summary>
        public static List<string> Names => PublishedMaterial.All.Select(published => published.Name).ToList();

        /// <summary>Finding for a refused value; null if none is.</summary>
        public static Finding Check(RadarMaterial material) => Finding.Of(() => material.ToSurface());

        /// <summary>Label, value and meaning.</summary>
        public static IEnumerable<(string label, string value, string tooltip)> Rows(RadarMaterial material)
        {
            var published = PublishedMaterial.All.FirstOrDefault(it => it.Name == material.Published);
            if (material.Kind != RadarMaterialKind.Published || published == null)
                yield break;
            yield return ("Reflects as", published.Coating is double thickness
                ? FormattableString.Invariant($"{thickness * 1000:0.###} mm on metal")
                : "half-space", "To use another thickness, add a layer with this published medium.");
            yield return ("Frequencies", $"{published.Medium.Frequencies} Hz",
                "Range of the published values. Other frequencies are refused.");
            yield return ("Source", published.Source, "Where the values are published.");
        }
    }
}
