using UnityEngine;
using UnityEngine.Rendering;

namespace Glint
{
    /// <summary>The material that the current render pipeline gives to new objects.</summary>
    public static class PipelineMaterial
    {
        /// <summary>Null in the built-in render pipeline, and in players.</summary>
        public static Material Default
        {
            get
            {
                var pipeline = GraphicsSettings.currentRenderPipeline;
                return pipeline == null ? null : pipeline.defaultMaterial;
            }
        }
    }
}
