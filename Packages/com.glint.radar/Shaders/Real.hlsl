#ifndef GLINT_REAL
#define GLINT_REAL

// The arithmetic of a path: float32 in the kernels that follow every ray, two floats in those that follow once more
// the rays that may be received. The path's code is the same.

#ifdef GLINT_EXACT

#include "TwoFloat.hlsl"

typedef Two Real;
typedef Two3 Real3;

Real MakeReal(float value, float rest)
{
    return MakeTwo(value, rest);
}

Real3 MakeReal3(float3 value, float3 rest)
{
    return MakeTwo3(MakeTwo(value.x, rest.x), MakeTwo(value.y, rest.y), MakeTwo(value.z, rest.z));
}

// Of a vector that is one already, beside the rounding.
Real3 UnitAgain(Real3 v)
{
    return v;
}

// Reception is decided as it is.
static const float DIRECTION_ERROR = 0.0;

#else

typedef float Real;
typedef float3 Real3;

Real MakeReal(float value, float rest)
{
    return value;
}

Real3 MakeReal3(float3 value, float3 rest)
{
    return value;
}

float3 Difference(float3 a, float3 b)
{
    return a - b;
}

Real3 UnitAgain(Real3 v)
{
    return normalize(v);
}

// So far off may a direction be, rad: within it a ray may be received.
static const float DIRECTION_ERROR = 4.0e-6;

float Rounded(float a)
{
    return a;
}

float3 Rounded(float3 a)
{
    return a;
}

float Plus(float a, float b)
{
    return a + b;
}

float3 Plus(float3 a, float3 b)
{
    return a + b;
}

float Minus(float a, float b)
{
    return a - b;
}

float3 Minus(float3 a, float3 b)
{
    return a - b;
}

float Times(float a, float b)
{
    return a * b;
}

float3 Times(float3 v, float s)
{
    return v * s;
}

float Over(float a, float b)
{
    return a / b;
}

float Root(float a)
{
    return sqrt(a);
}

float Dot(float3 a, float3 b)
{
    return dot(a, b);
}

float3 Cross(float3 a, float3 b)
{
    return cross(a, b);
}

#endif

// Distance along a ray to a plane through a point, m.
Real ToPlane(Real3 origin, Real3 direction, Real3 onPlane, Real3 normal)
{
    return Over(Dot(normal, Minus(onPlane, origin)), Dot(normal, direction));
}

#endif
