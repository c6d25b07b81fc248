using System;
using Glint.Core;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint
{
    static class RadarSearch
    {
        /// <summary>The one enabled radar of the loaded scenes.</summary>
        /// <param name="searcher">Who looks for it, for the message.</param>
        /// <exception cref="GlintException">There is none, or more than one.</exception>
        public static RadarController FindOnly(string searcher)
        {
            var all = Object.FindObjectsByType<RadarController>(FindObjectsInactive.Include, FindObjectsSortMode.None);
            var radars = Array.FindAll(all, radar => radar.isActiveAndEnabled);
            if (all.Length == 0)
                throw new GlintException($"{searcher}: has no radar; add a RadarController (Glint > Radar Controller) to a camera of the scene");
            if (radars.Length == 0)
                throw new GlintException($"{searcher}: its RadarController of '{all[0].name}' is disabled or inactive; enable it");
            if (radars.Length > 1)
                throw new GlintException($"{searcher}: has {radars.Length} radars, '{string.Join("', '", Array.ConvertAll(radars, radar => radar.name))}'; disable all but one");
            return radars[0];
        }
    }
}
