using System.Linq;
using UnityEngine;

namespace Glint
{
    // Names as in Shaders/Bindings.hlsl.
    static class ShaderIDs
    {
        public static readonly int[] _Tree = Enumerable.Range(0, DeviceTrees.MostBanks).Select(bank => Shader.PropertyToID("_Tree" + bank)).ToArray();
        public static readonly int _Top = Shader.PropertyToID("_Top");
        public static readonly int _Instances = Shader.PropertyToID("_Instances");
        public static readonly int _FewToLocal = Shader.PropertyToID("_FewToLocal");
        public static readonly int _FewFirstRow = Shader.PropertyToID("_FewFirstRow");
        public static readonly int _InstanceCount = Shader.PropertyToID("_InstanceCount");
        public static readonly int _TopRoot = Shader.PropertyToID("_TopRoot");

        public static readonly int _CameraPosition = Shader.PropertyToID("_CameraPosition");
        public static readonly int _CameraRight = Shader.PropertyToID("_CameraRight");
        public static readonly int _CameraUp = Shader.PropertyToID("_CameraUp");
        public static readonly int _CameraForward = Shader.PropertyToID("_CameraForward");
        public static readonly int _ReceiverCentre = Shader.PropertyToID("_ReceiverCentre");
        public static readonly int _ReceiverRight = Shader.PropertyToID("_ReceiverRight");
        public static readonly int _ReceiverUp = Shader.PropertyToID("_ReceiverUp");
        public static readonly int _ReceiverForward = Shader.PropertyToID("_ReceiverForward");
        public static readonly int _RaysAcross = Shader.PropertyToID("_RaysAcross");
        public static readonly int _RaysDown = Shader.PropertyToID("_RaysDown");
        public static readonly int _Region = Shader.PropertyToID("_Region");
        public static readonly int _MaxBounces = Shader.PropertyToID("_MaxBounces");
        public static readonly int _WaveNumberTurns = Shader.PropertyToID("_WaveNumberTurns");

        public static readonly int _Tiles = Shader.PropertyToID("_Tiles");
        public static readonly int _Starts = Shader.PropertyToID("_Starts");
        public static readonly int _FoundStarts = Shader.PropertyToID("_FoundStarts");
        public static readonly int _FirstTile = Shader.PropertyToID("_FirstTile");
        public static readonly int _TileCount = Shader.PropertyToID("_TileCount");
        public static readonly int _Shortcuts = Shader.PropertyToID("_Shortcuts");
        public static readonly int _Keep = Shader.PropertyToID("_Keep");
        public static readonly int _RayCapacity = Shader.PropertyToID("_RayCapacity");
        public static readonly int _LengthUnits = Shader.PropertyToID("_LengthUnits");

        public static readonly int _Rays = Shader.PropertyToID("_Rays");
        public static readonly int _Sums = Shader.PropertyToID("_Sums");
    }
}
