using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The material of a surface, as an asset: so far a perfect conductor under the asset's name.
    /// A <see cref="RadarSurface"/> gives it to objects.
    /// </summary>
    [CreateAssetMenu(menuName = "Glint/Radar Material")]
    public sealed class RadarMaterial : ScriptableObject
    {
        SurfaceMaterial _material;

        /// <summary>The material as scenes and results have it; the same object as long as the name stays.</summary>
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
