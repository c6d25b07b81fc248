#ifndef GLINT_SCREEN_POINTS
#define GLINT_SCREEN_POINTS

// GLINT_SCREEN_POINT: Core/Screen/ScreenGeometry.cs, where the fields are explained.
struct ScreenPoint
{
    float3 Position;
    float Amplitude;
    float2 Field;
    int Spoke;
    int Cell;
};

StructuredBuffer<ScreenPoint> _ScreenPoints;
uint _ScreenPointCount;

// Whether a point has an echo in the spokes of this dispatch.
bool IsInSlice(ScreenPoint echo)
{
    return echo.Amplitude != 0.0 && IsSpokeInSlice(echo.Spoke);
}

#if !defined(GLINT_SCREEN_SEA)

[numthreads(64, 1, 1)]
void ScreenPoints(uint3 id : SV_DispatchThreadID)
{
    if (id.x >= _ScreenPointCount)
        return;
    ScreenPoint echo = _ScreenPoints[id.x];
    if (IsInSlice(echo))
        AddEcho(echo.Spoke, echo.Cell, echo.Field);
}

#endif

#endif
