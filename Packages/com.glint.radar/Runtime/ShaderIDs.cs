using UnityEngine;

namespace Glint
{
    // Names as in Shaders/Bindings.hlsl.
    static class ShaderIDs
    {
        public static readonly int _Nodes = Shader.PropertyToID("_Nodes");
        public static readonly int _Triangles = Shader.PropertyToID("_Triangles");
        public static readonly int _TriangleCount = Shader.PropertyToID("_TriangleCount");

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
        public static readonly int _MaxBounces = Shader.PropertyToID("_MaxBounces");
        public static readonly int _WaveNumberTurns = Shader.PropertyToID("_WaveNumberTurns");
        public static readonly int _KeepAll = Shader.PropertyToID("_KeepAll");
        public static readonly int _RayCapacity = Shader.PropertyToID("_RayCapacity");

        public static readonly int _Rays = Shader.PropertyToID("_Rays");
        public static readonly int _RayCounter = Shader.PropertyToID("_RayCounter");
        public static readonly int _GroupSums = Shader.PropertyToID("_GroupSums");
    }
}
