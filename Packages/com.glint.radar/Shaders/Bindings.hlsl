#ifndef GLINT_BINDINGS
#define GLINT_BINDINGS

#include "Types.hlsl"

// Input: the scene.
StructuredBuffer<BvhNode> _Nodes;           // node 0 is the root
StructuredBuffer<TriangleRecord> _Triangles;
uint _TriangleCount;                        // 0: nothing to hit, the buffers are not read

// Input: the radar. Positions in m; axes are unit vectors.
float4 _CameraPosition;
float4 _CameraRight;                        // times half the picture's width at distance 1
float4 _CameraUp;                           // times half the picture's height at distance 1
float4 _CameraForward;
float4 _ReceiverCentre;
float4 _ReceiverRight;                      // divided by half the receiver's width
float4 _ReceiverUp;                         // divided by half the receiver's height
float4 _ReceiverForward;
uint _RaysAcross;
uint _RaysDown;
uint _MaxBounces;
float _WaveNumberTurns;                     // 1 / wavelength, turns per m
uint _KeepAll;                              // 1: every ray is written at its pixel; 0: received rays only, in any order
uint _RayCapacity;                          // rays that _Rays holds

// Output.
RWStructuredBuffer<RayData> _Rays;
RWStructuredBuffer<uint> _RayCounter;       // rays written, or wanting to be when _Rays is full
RWStructuredBuffer<GroupSum> _GroupSums;    // one a thread group

#endif
