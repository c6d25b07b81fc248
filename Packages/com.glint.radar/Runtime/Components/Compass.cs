using System;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Where north is in a scene: the forward axis (Z) of this object, seen from above. Without a compass it is +Z of
    /// the world. Bearings are clockwise from there.
    /// </summary>
    [AddComponentMenu("Glint/Compass")]
    [HelpPage("screen.md")]
    [DisallowMultipleComponent]
    public sealed class Compass : MonoBehaviour
    {
        /// <summary>Rotation about Y from +Z to north, turns.</summary>
        public double NorthTurns => TurnsOf(transform.forward);

        /// <summary>Rotation about Y from +Z to a direction, turns from -0.5 to 0.5.</summary>
        internal static double TurnsOf(Vector3 direction) => Math.Atan2(direction.x, direction.z) / (2 * Math.PI);

        /// <summary>The only enabled compass of the loaded scenes; null: there is none.</summary>
        /// <exception cref="GlintException">There is more than one.</exception>
        internal static Compass Find(string searcher)
        {
            var all = SceneSearch.FindEnabled<Compass>();
            if (all.Length > 1)
                throw new GlintException($"{searcher}: the scene has {all.Length} compasses, "
                    + $"'{string.Join("', '", Array.ConvertAll(all, compass => compass.name))}'; disable all but one");
            return all.Length == 1 ? all[0] : null;
        }
    }
}
