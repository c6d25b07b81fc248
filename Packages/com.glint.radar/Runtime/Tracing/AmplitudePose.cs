using System.Runtime.InteropServices;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    // GLINT_AMPLITUDE_POSE: Shaders/AmplitudePath.hlsl, where the fields are explained.
    [StructLayout(LayoutKind.Sequential)]
    struct AmplitudePose
    {
        public float4 Aside, ReceiverCentre, ReceiverRight, ReceiverUp, ReceiverForward;
        public float2 PictureStart, PictureStep;
        public uint EmptyLevel, FirstInstance, FirstRow, Unused;

        public AmplitudePose(in RadarView view, RayGrid rays, AmplitudeGrid grid)
        {
            this = default;
            Aside = TubePose.RowOf(rays.Direction - view.Forward, view.IsParallel ? 1 : 0);
            ReceiverCentre = TubePose.RowOf(view.ReceiverCentre - rays.SceneCentre);
            ReceiverRight = TubePose.RowOf(view.ReceiverRight, view.ReceiverSize.x / 2);
            ReceiverUp = TubePose.RowOf(view.ReceiverUp, view.ReceiverSize.y / 2);
            ReceiverForward = TubePose.RowOf(view.ReceiverForward, ReceiverDepth(view, rays));
            (PictureStart, PictureStep) = ((float2)(grid.Lower - rays.ReferencePixel), (float2)grid.Step);
        }

        /// <summary>Distance from the receiver's plane to the scene's centre, metres.</summary>
        public static double ReceiverDepth(in RadarView view, RayGrid rays) =>
            math.dot(rays.SceneCentre - view.ReceiverCentre, view.ReceiverForward);
    }
}
