using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Glint
{
    /// <summary>Unity's terrains, which have no mesh and are not traced.</summary>
    static class Terrains
    {
        // By name: a project may lack the module.
        static readonly Type s_type = Type.GetType("UnityEngine.Terrain, UnityEngine.TerrainModule");

        /// <summary>Names of the terrains that a radar would see.</summary>
        /// <param name="roots">Empty: every loaded scene.</param>
        public static string[] Seen(LayerMask layers, IReadOnlyList<Transform> roots)
        {
            if (s_type == null)
                return Array.Empty<string>();
            return UnityEngine.Object.FindObjectsByType(s_type, FindObjectsInactive.Exclude, FindObjectsSortMode.None)
                .Cast<Behaviour>()
                .Where(terrain => terrain.enabled && (layers.value & (1 << terrain.gameObject.layer)) != 0
                    && (roots.Count == 0 || roots.Any(terrain.transform.IsChildOf)))
                .Select(terrain => terrain.name).OrderBy(name => name, StringComparer.Ordinal).ToArray();
        }
    }
}
