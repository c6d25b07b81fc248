using System.Linq;
using UnityEngine;

namespace Glint
{
    // Names as in Shaders/Bindings.hlsl.
    static class ShaderIDs
    {
        public static readonly int[] _Tree = Enumerable.Range(0, DeviceTrees.MostBanks)
            .Select(bank => Shader.PropertyToID("_Tree" + bank)).ToArray();
        public static readonly int _Top = Shader.PropertyToID("_Top");
        public static readonly int _Instances = Shader.PropertyToID("_Instances");
        public static readonly int _FewToLocal = Shader.PropertyToID("_FewToLocal");
        public static readonly int _FewFirstRow = Shader.PropertyToID("_FewFirstRow");
        public static readonly int _InstanceCount = Shader.PropertyToID("_InstanceCount");
        public static readonly int _TopRoot = Shader.PropertyToID("_TopRoot");

        public static readonly (int value, int rest) _Start = WithRest(nameof(_Start));
        public static readonly (int value, int rest) _StartRight = WithRest(nameof(_StartRight));
        public static readonly (int value, int rest) _StartUp = WithRest(nameof(_StartUp));
        public static readonly (int value, int rest) _Course = WithRest(nameof(_Course));
        public static readonly (int value, int rest) _CourseRight = WithRest(nameof(_CourseRight));
        public static readonly (int value, int rest) _CourseUp = WithRest(nameof(_CourseUp));
        public static readonly (int value, int rest) _ReceiverCentre = WithRest(nameof(_ReceiverCentre));
        public static readonly (int value, int rest) _ReceiverRight = WithRest(nameof(_ReceiverRight));
        public static readonly (int value, int rest) _ReceiverUp = WithRest(nameof(_ReceiverUp));
        public static readonly (int value, int rest) _ReceiverForward = WithRest(nameof(_ReceiverForward));
        public static readonly int _ReceiverHalfSize = Shader.PropertyToID("_ReceiverHalfSize");
        public static readonly int _StartDepth = Shader.PropertyToID("_StartDepth");
        public static readonly int _ReferenceRay = Shader.PropertyToID("_ReferenceRay");
        public static readonly int _Middle = Shader.PropertyToID("_Middle");
        public static readonly int _RaysAcross = Shader.PropertyToID("_RaysAcross");
        public static readonly int _Region = Shader.PropertyToID("_Region");
        public static readonly int _MaxBounces = Shader.PropertyToID("_MaxBounces");
        public static readonly int _WaveNumberTurns = Shader.PropertyToID("_WaveNumberTurns");

        public static readonly int _Tiles = Shader.PropertyToID("_Tiles");
        public static readonly int _Starts = Shader.PropertyToID("_Starts");
        public static readonly int _FoundStarts = Shader.PropertyToID("_FoundStarts");
        public static readonly int _Hits = Shader.PropertyToID("_Hits");
        public static readonly int _FirstTile = Shader.PropertyToID("_FirstTile");
        public static readonly int _TileCount = Shader.PropertyToID("_TileCount");
        public static readonly int _Shortcuts = Shader.PropertyToID("_Shortcuts");
        public static readonly int _Keep = Shader.PropertyToID("_Keep");
        public static readonly int _FirstReturning = Shader.PropertyToID("_FirstReturning");
        public static readonly int _ReturningCount = Shader.PropertyToID("_ReturningCount");
        public static readonly int _SubRays = Shader.PropertyToID("_SubRays");
        public static readonly int _LengthUnits = Shader.PropertyToID("_LengthUnits");

        public static readonly int _Returning = Shader.PropertyToID("_Returning");
        public static readonly int _Rays = Shader.PropertyToID("_Rays");
        public static readonly int _Sums = Shader.PropertyToID("_Sums");

        static (int, int) WithRest(string name) => (Shader.PropertyToID(name), Shader.PropertyToID(name + "Rest"));
    }
}
