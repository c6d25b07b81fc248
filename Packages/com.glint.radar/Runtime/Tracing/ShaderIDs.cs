using System.Linq;
using UnityEngine;

namespace Glint
{
    // Names as in Shaders/Bindings.hlsl and Shaders/Stages.hlsl.
    static class ShaderIDs
    {
        public static readonly int[] _Bvh = Enumerable.Range(0, DeviceBvhs.MaxPages)
            .Select(page => Shader.PropertyToID("_Bvh" + page)).ToArray();
        public static readonly int _InstanceBvh = Shader.PropertyToID("_InstanceBvh");
        public static readonly int _Instances = Shader.PropertyToID("_Instances");
        public static readonly int _Ranges = Shader.PropertyToID("_Ranges");
        public static readonly int _InlineToLocal = Shader.PropertyToID("_InlineToLocal");
        public static readonly int _InlineRows = Shader.PropertyToID("_InlineRows");
        public static readonly int _InstanceCount = Shader.PropertyToID("_InstanceCount");
        public static readonly int _InstanceBvhRoot = Shader.PropertyToID("_InstanceBvhRoot");

        public static readonly (int value, int lo) _Origin = WithLo(nameof(_Origin));
        public static readonly (int value, int lo) _OriginDx = WithLo(nameof(_OriginDx));
        public static readonly (int value, int lo) _OriginDy = WithLo(nameof(_OriginDy));
        public static readonly (int value, int lo) _Direction = WithLo(nameof(_Direction));
        public static readonly (int value, int lo) _DirectionDx = WithLo(nameof(_DirectionDx));
        public static readonly (int value, int lo) _DirectionDy = WithLo(nameof(_DirectionDy));
        public static readonly (int value, int lo) _ReceiverCentre = WithLo(nameof(_ReceiverCentre));
        public static readonly (int value, int lo) _ReceiverRight = WithLo(nameof(_ReceiverRight));
        public static readonly (int value, int lo) _ReceiverUp = WithLo(nameof(_ReceiverUp));
        public static readonly (int value, int lo) _ReceiverForward = WithLo(nameof(_ReceiverForward));
        public static readonly int _ReceiverHalfSize = Shader.PropertyToID("_ReceiverHalfSize");
        public static readonly int _OriginDepth = Shader.PropertyToID("_OriginDepth");
        public static readonly int _ReferencePixel = Shader.PropertyToID("_ReferencePixel");
        public static readonly int _SceneCentreExtent = Shader.PropertyToID("_SceneCentreExtent");
        public static readonly int _RaysAcross = Shader.PropertyToID("_RaysAcross");
        public static readonly int _Region = Shader.PropertyToID("_Region");
        public static readonly int _MaxBounces = Shader.PropertyToID("_MaxBounces");
        public static readonly int _WaveNumberTurns = Shader.PropertyToID("_WaveNumberTurns");

        public static readonly int _Cells = Shader.PropertyToID("_Cells");
        public static readonly int _CellSize = Shader.PropertyToID("_CellSize");
        public static readonly int _CellInverse = Shader.PropertyToID("_CellInverse");
        public static readonly int _EntryPoints = Shader.PropertyToID("_EntryPoints");
        public static readonly int _FoundEntryPoints = Shader.PropertyToID("_FoundEntryPoints");
        public static readonly int _Hits = Shader.PropertyToID("_Hits");
        public static readonly int _TileCount = Shader.PropertyToID("_TileCount");
        public static readonly int _Culling = Shader.PropertyToID("_Culling");
        public static readonly int _Readback = Shader.PropertyToID("_Readback");
        public static readonly int _HasSubRays = Shader.PropertyToID("_HasSubRays");
        public static readonly int _SubRayPixels = Shader.PropertyToID("_SubRayPixels");
        public static readonly int _MaxSpread = Shader.PropertyToID("_MaxSpread");
        public static readonly int _KnownCapacity = Shader.PropertyToID("_KnownCapacity");
        public static readonly int _FirstSearched = Shader.PropertyToID("_FirstSearched");
        public static readonly int _PathCount = Shader.PropertyToID("_PathCount");
        public static readonly int _ReceivedCapacity = Shader.PropertyToID("_ReceivedCapacity");
        public static readonly int _FirstReceived = Shader.PropertyToID("_FirstReceived");
        public static readonly int _HasLengths = Shader.PropertyToID("_HasLengths");
        public static readonly int _LengthUnits = Shader.PropertyToID("_LengthUnits");

        public static readonly int _Candidates = Shader.PropertyToID("_Candidates");
        public static readonly int _Met = Shader.PropertyToID("_Met");
        public static readonly int _Lengths = Shader.PropertyToID("_Lengths");

        public static readonly int _TraceGroup = Shader.PropertyToID("_TraceGroup");
        public static readonly int _RefineGroup = Shader.PropertyToID("_RefineGroup");
        public static readonly int _MaxSlope = Shader.PropertyToID("_MaxSlope");
        public static readonly int _MaxBend = Shader.PropertyToID("_MaxBend");
        public static readonly int _MaxTwist = Shader.PropertyToID("_MaxTwist");
        public static readonly int _Arguments = Shader.PropertyToID("_Arguments");
        public static readonly int _ChosenPixels = Shader.PropertyToID("_ChosenPixels");
        public static readonly int _Rays = Shader.PropertyToID("_Rays");
        public static readonly int _Sums = Shader.PropertyToID("_Sums");

        static (int, int) WithLo(string name) => (Shader.PropertyToID(name), Shader.PropertyToID(name + "Lo"));
    }
}
