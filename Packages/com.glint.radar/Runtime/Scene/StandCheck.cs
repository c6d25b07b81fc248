using System;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Looks for numbers that are none in what a radar, receiver or target stands on:
    /// Unity refuses them from scripts, and takes them from files.
    /// </summary>
    static class StandCheck
    {
        /// <summary>Refuses a place that is not finite.</summary>
        /// <param name="subject">What stands there, for the message.</param>
        /// <exception cref="GlintException">
        /// A position, rotation or scale of the transform or of one above it is not finite; the message names it.
        /// </exception>
        public static void RefuseNowhere(in Affine stand, Transform place, string subject)
        {
            if (!math.all(math.isfinite(stand.X + stand.Y + stand.Z + stand.Origin)))
                RefuseNowhere(place, subject);
        }

        /// <inheritdoc cref="RefuseNowhere(in Affine, Transform, string)"/>
        public static void RefuseNowhere(Transform place, string subject)
        {
            for (var at = place; at != null; at = at.parent)
                if (WhatIsNotFinite(at) is string what)
                    throw new GlintException($"{subject} stands nowhere: "
                        + $"the {what} of '{at.name}'{(at == place ? "" : ", above it,")} is not finite: set it anew");
        }

        static string WhatIsNotFinite(Transform transform)
        {
            Vector3 position = transform.localPosition, scale = transform.localScale;
            var rotation = transform.localRotation;
            return !AreFinite(rotation.x, rotation.y, rotation.z, rotation.w) ? "rotation"
                : !AreFinite(position.x, position.y, position.z) ? "position"
                : !AreFinite(scale.x, scale.y, scale.z) ? "scale" : null;
        }

        static bool AreFinite(params float[] numbers) => Array.TrueForAll(numbers, math.isfinite);
    }
}
