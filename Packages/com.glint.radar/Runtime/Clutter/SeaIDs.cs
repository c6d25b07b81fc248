using UnityEngine;

namespace Glint
{
    // Names as in Shaders/SeaFacets.hlsl, SeaLights.hlsl and Footprint.hlsl.
    static class SeaIDs
    {
        public static readonly int _SeaFacets = Shader.PropertyToID("_SeaFacets");
        public static readonly int _SeaVelocities = Shader.PropertyToID("_SeaVelocities");
        public static readonly int _SeaElapsed = Shader.PropertyToID("_SeaElapsed");
        public static readonly int _SeaWaveNumber = Shader.PropertyToID("_SeaWaveNumber");
        public static readonly int _SeaTiles = Shader.PropertyToID("_SeaTiles");
        public static readonly int _FacetTable = Shader.PropertyToID("_FacetTable");
        public static readonly int _SeaBreaking = Shader.PropertyToID("_SeaBreaking");
        public static readonly int _SeaLights = Shader.PropertyToID("_SeaLights");
        public static readonly int _SeaLightCount = Shader.PropertyToID("_SeaLightCount");
        public static readonly int _SeaGroup = Shader.PropertyToID("_SeaGroup");
        public static readonly int _SeaRange = Shader.PropertyToID("_SeaRange");
        public static readonly int _SeaWind = Shader.PropertyToID("_SeaWind");
        public static readonly int _SeaTurns = Shader.PropertyToID("_SeaTurns");
        public static readonly int _SeaMoment = Shader.PropertyToID("_SeaMoment");
        public static readonly int _SeaTime = Shader.PropertyToID("_SeaTime");
        public static readonly int _SeaMirror = Shader.PropertyToID("_SeaMirror");
        public static readonly int _SeaLevels = Shader.PropertyToID("_SeaLevels");
        public static readonly int _SeaLevelCount = Shader.PropertyToID("_SeaLevelCount");
        public static readonly int _FootprintPosition = Shader.PropertyToID("_FootprintPosition");
        public static readonly int _FootprintRight = Shader.PropertyToID("_FootprintRight");
        public static readonly int _FootprintUp = Shader.PropertyToID("_FootprintUp");
        public static readonly int _FootprintForward = Shader.PropertyToID("_FootprintForward");
        public static readonly int _SeaCellX = Shader.PropertyToID("_SeaCellX");
        public static readonly int _SeaCellY = Shader.PropertyToID("_SeaCellY");
        public static readonly int _SeaCells = Shader.PropertyToID("_SeaCells");
    }
}
