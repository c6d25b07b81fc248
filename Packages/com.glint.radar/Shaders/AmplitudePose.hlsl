#ifndef GLINT_AMPLITUDE_POSE
#define GLINT_AMPLITUDE_POSE

// GLINT_AMPLITUDE_POSE: what a pose has beside a TubePose (Runtime/Tracing/AmplitudePose.cs).
struct AmplitudePose
{
    float4 Aside;                          // xyz: TubePose.Direction less the view axis; w: 1 for parallel rays
    float4 ReceiverCentre;                 // relative to the scene's centre, m
    float4 ReceiverRight, ReceiverUp;      // unit vectors; w: half its width and height, m
    float4 ReceiverForward;                // unit vector; w: distance from the receiver's plane to the scene's centre, m
    float2 PictureStart;                   // lower left corner of the grid, in rays from RayGrid.ReferencePixel
    float2 PictureStep;                    // rays a base cell
    uint EmptyLevel;                       // cells at it of which no corner is received are not divided
    uint FirstInstance, FirstRow;          // of its scene: s_firstInstance, s_firstRow
    uint Unused;
};

#endif
