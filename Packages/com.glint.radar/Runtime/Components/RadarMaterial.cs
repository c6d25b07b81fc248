using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The material of a surface, as an asset: at present a perfect conductor with the asset's name.
    /// A <see cref="RadarSurface"/> assigns it to objects.
    /// </summary>
    [CreateAssetMenu(menuName = "Glint/Radar Material")]
    public sealed class RadarMaterial : ScriptableObject
    {
        SurfaceMaterial _material;

        /// <summary>The material in scenes and results; the same object while the name stays.</summary>
        internal SurfaceMaterial Material
        {
            get
            {
                if (_material?.Name != name)
                    _material = new SurfaceMaterial(name);
                return _material;
            }
        }
    }
}
