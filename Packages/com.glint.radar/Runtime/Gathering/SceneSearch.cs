using System;
using Glint.Core;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint
{
    /// <summary>Finds the only component of a kind in the scene.</summary>
    public static class SceneSearch
    {
        /// <summary>The only enabled radar of the loaded scenes.</summary>
        /// <param name="searcher">Name of the caller, for the message.</param>
        /// <exception cref="GlintException">There is none, or more than one.</exception>
        public static RadarController FindRadar(string searcher) => FindOnly<RadarController>(searcher, "radar",
            "RadarController (Glint > Radar Controller) to a camera of the scene");

        /// <summary>The only enabled sea of the loaded scenes.</summary>
        /// <param name="searcher">Name of the caller, for the message.</param>
        /// <exception cref="GlintException">There is none, or more than one.</exception>
        public static Sea FindSea(string searcher) =>
            FindOnly<Sea>(searcher, "Sea component", "Sea (Glint > Sea) with snapshots to an object of the scene");

        /// <summary>All enabled components of a kind in the loaded scenes.</summary>
        public static T[] FindEnabled<T>() where T : Behaviour =>
            Array.FindAll(Object.FindObjectsByType<T>(FindObjectsInactive.Exclude, FindObjectsSortMode.None),
                found => found.isActiveAndEnabled);

        /// <summary>Message for a component that is disabled.</summary>
        public static string IsDisabled(Behaviour component) =>
            $"{component.GetType().Name} of '{component.name}' is disabled or inactive; enable it";

        /// <summary>The only enabled component of a kind in the loaded scenes.</summary>
        /// <param name="searcher">Name of the caller, for the message.</param>
        /// <param name="noun">What it is, for the message.</param>
        /// <param name="remedy">What to add where there is none.</param>
        /// <exception cref="GlintException">There is none, or more than one.</exception>
        public static T FindOnly<T>(string searcher, string noun, string remedy) where T : Behaviour
        {
            var all = Object.FindObjectsByType<T>(FindObjectsInactive.Include, FindObjectsSortMode.None);
            var enabled = Array.FindAll(all, found => found.isActiveAndEnabled);
            if (all.Length == 0)
                throw new GlintException($"{searcher}: has no {noun}; add a {remedy}");
            if (enabled.Length == 0)
                throw new GlintException($"{searcher}: its {IsDisabled(all[0])}");
            if (enabled.Length > 1)
                throw new GlintException($"{searcher}: has {enabled.Length} {noun}s, "
                    + $"'{string.Join("', '", Array.ConvertAll(enabled, found => found.name))}'; disable all but one");
            return enabled[0];
        }
    }
}
