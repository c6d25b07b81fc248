using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The material of a surface, as an asset: at present a perfect conductor with the asset's name.
    /// A <see cref="RadarSurface"/> assigns it to objects.
    /// </summary>
    [CreateAssetMenu(menuName = "Glint/Radar Material")]
    [HelpPage("editor.md")]
    public sealed class RadarMaterial : ScriptableObject
    {
        /// <summary>The material in scenes and results.</summary>
        internal SurfaceMaterial Material => new SurfaceMaterial(name);
    }
}
