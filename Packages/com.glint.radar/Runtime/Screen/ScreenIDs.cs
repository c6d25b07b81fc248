using UnityEngine;

namespace Glint
{
    // Names as in Shaders/Screen*.hlsl.
    static class ScreenIDs
    {
        public static readonly int _ScreenSize = Shader.PropertyToID("_ScreenSize");
        public static readonly int _ScreenSlice = Shader.PropertyToID("_ScreenSlice");
        public static readonly int _Echo = Shader.PropertyToID("_Echo");
        public static readonly int _ScreenEcho = Shader.PropertyToID("_ScreenEcho");
        public static readonly int _RainLoss = Shader.PropertyToID("_RainLoss");
        public static readonly int _ScreenPoints = Shader.PropertyToID("_ScreenPoints");
        public static readonly int _ScreenPointCount = Shader.PropertyToID("_ScreenPointCount");
        public static readonly int _ScreenSea = Shader.PropertyToID("_ScreenSea");
        public static readonly int _ScreenSeaSeed = Shader.PropertyToID("_ScreenSeaSeed");
        public static readonly int _ScreenSeaCorner = Shader.PropertyToID("_ScreenSeaCorner");
        public static readonly int _SeaMeanView = Shader.PropertyToID("_SeaMeanView");
        public static readonly int _SeaMeans = Shader.PropertyToID("_SeaMeans");
        public static readonly int _SurfaceSamples = Shader.PropertyToID("_SurfaceSamples");
        public static readonly int _SurfaceSampleCount = Shader.PropertyToID("_SurfaceSampleCount");
        public static readonly int _SurfaceFrames = Shader.PropertyToID("_SurfaceFrames");
        public static readonly int _SurfaceScatter = Shader.PropertyToID("_SurfaceScatter");
        public static readonly int _ScreenAntenna = Shader.PropertyToID("_ScreenAntenna");
        public static readonly int _ScreenNorth = Shader.PropertyToID("_ScreenNorth");
        public static readonly int _ScreenWaves = Shader.PropertyToID("_ScreenWaves");
        public static readonly int _Echoes = Shader.PropertyToID("_Echoes");
        public static readonly int _BeamWeights = Shader.PropertyToID("_BeamWeights");
        public static readonly int _ElevationField = Shader.PropertyToID("_ElevationField");
        public static readonly int _ForeignPulses = Shader.PropertyToID("_ForeignPulses");
        public static readonly int _ForeignRadars = Shader.PropertyToID("_ForeignRadars");
        public static readonly int _BlindSector = Shader.PropertyToID("_BlindSector");
        public static readonly int _PulseWeights = Shader.PropertyToID("_PulseWeights");
        public static readonly int _PulseCells = Shader.PropertyToID("_PulseCells");
        public static readonly int _Signals = Shader.PropertyToID("_Signals");
        public static readonly int _Levels = Shader.PropertyToID("_Levels");
        public static readonly int _Video = Shader.PropertyToID("_Video");
        public static readonly int _Receiver = Shader.PropertyToID("_Receiver");
        public static readonly int _ReceiverFilters = Shader.PropertyToID("_ReceiverFilters");
        public static readonly int _ShownVideo = Shader.PropertyToID("_ShownVideo");
        public static readonly int _Trails = Shader.PropertyToID("_Trails");
        public static readonly int _TrailFrame = Shader.PropertyToID("_TrailFrame");
        public static readonly int _ShownTrails = Shader.PropertyToID("_ShownTrails");
        public static readonly int _Picture = Shader.PropertyToID("_Picture");
        public static readonly int _PictureView = Shader.PropertyToID("_PictureView");
        public static readonly int _PictureFade = Shader.PropertyToID("_PictureFade");
        public static readonly int _PictureTrail = Shader.PropertyToID("_PictureTrail");
        public static readonly int _PictureHeading = Shader.PropertyToID("_PictureHeading");
        public static readonly int _PictureBearing = Shader.PropertyToID("_PictureBearing");
        public static readonly int _PictureColours = Shader.PropertyToID("_PictureColours");
    }
}
