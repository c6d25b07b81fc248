using System;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Finds NaN and infinity in the transforms of radar, receiver and target: Unity refuses them from scripts, but not
    /// from files.
    /// </summary>
    static class FiniteCheck
    {
        /// <summary>Refuses a transform that is not finite.</summary>
        /// <param name="subject">Name of the object, for the message.</param>
        /// <exception cref="GlintException">
        /// A position, rotation or scale of the transform or of one above it is not finite; the message names it.
        /// </exception>
        public static void RefuseNotFinite(in Affine pose, Transform node, string subject)
        {
            if (!math.all(math.isfinite(pose.X + pose.Y + pose.Z + pose.Origin)))
                RefuseNotFinite(node, subject);
        }

        /// <inheritdoc cref="RefuseNotFinite(in Affine, Transform, string)"/>
        public static void RefuseNotFinite(Transform node, string subject)
        {
            for (var at = node; at != null; at = at.parent)
                if (WhatIsNotFinite(at) is string what)
                    throw new GlintException($"{subject} has no valid position: "
                        + $"the {what} of '{at.name}'{(at == node ? "" : ", above it,")} is not finite: set it again");
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
