using UnityEngine;

namespace Glint
{
    // Names as in Shaders/SeaField.hlsl, SeaTransform.hlsl, SeaBounds.hlsl and SeaMarch.hlsl.
    static class SeaFieldIDs
    {
        public static readonly int _SeaCascades = Shader.PropertyToID("_SeaCascades");
        public static readonly int _SeaCascadeCount = Shader.PropertyToID("_SeaCascadeCount");
        public static readonly int _SeaWaves = Shader.PropertyToID("_SeaWaves");
        public static readonly int _SeaSeconds = Shader.PropertyToID("_SeaSeconds");
        public static readonly int _SeaFraction = Shader.PropertyToID("_SeaFraction");
        public static readonly int _WrittenSeaPoints = Shader.PropertyToID("_WrittenSeaPoints");
        public static readonly int _SeaPoints = Shader.PropertyToID("_SeaPoints");
        public static readonly int _WrittenSeaBounds = Shader.PropertyToID("_WrittenSeaBounds");
        public static readonly int _SeaBounds = Shader.PropertyToID("_SeaBounds");
        public static readonly int _SeaRadar = Shader.PropertyToID("_SeaRadar");
        public static readonly int _SeaTopLevel = Shader.PropertyToID("_SeaTopLevel");
    }
}
