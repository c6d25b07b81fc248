#ifndef GLINT_FOOTPRINT
#define GLINT_FOOTPRINT

// The camera's picture, outside of which nothing is lit.
float4 _FootprintPosition;                 // relative to the scene's centre, m; w: 0: everything is lit
float4 _FootprintRight, _FootprintUp;      // w: half the picture's width and height, at a distance of 1 or of parallel rays
float4 _FootprintForward;                  // w: 1: parallel rays

bool IsInFootprint(float3 position)
{
    float3 from = position - _FootprintPosition.xyz;
    float ahead = dot(from, _FootprintForward.xyz), reach = _FootprintForward.w != 0.0 ? 1.0 : ahead;
    return _FootprintPosition.w == 0.0 || ahead > 0.0 && abs(dot(from, _FootprintRight.xyz)) <= reach * _FootprintRight.w
        && abs(dot(from, _FootprintUp.xyz)) <= reach * _FootprintUp.w;
}

#endif
