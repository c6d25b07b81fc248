#ifndef GLINT_REAL
#define GLINT_REAL

// Arithmetic of paths: float32 in the kernels that trace every ray, double-float in the refine kernels. The code of
// paths is the same.

#ifdef GLINT_REFINE

#include "DoubleFloat.hlsl"

typedef DoubleFloat Real;
typedef DoubleFloat3 Real3;

Real MakeReal(float value, float lo)
{
    return MakeDoubleFloat(value, lo);
}

Real3 MakeReal3(float3 value, float3 lo)
{
    return MakeDoubleFloat3(MakeDoubleFloat(value.x, lo.x), MakeDoubleFloat(value.y, lo.y),
        MakeDoubleFloat(value.z, lo.z));
}

// Normalises a vector that is a unit vector up to rounding.
Real3 UnitAgain(Real3 v)
{
    return v;
}

// The refine kernels decide reception without tolerance.
static const float DIRECTION_ERROR = 0.0;

#else

typedef float Real;
typedef float3 Real3;

Real MakeReal(float value, float lo)
{
    return value;
}

Real3 MakeReal3(float3 value, float3 lo)
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

// Tolerance of float32 directions in the test for reception, rad.
static const float DIRECTION_ERROR = 4.0e-6;

float Rounded(float a)
{
    return a;
}

float3 Rounded(float3 a)
{
    return a;
}

float Add(float a, float b)
{
    return a + b;
}

float3 Add(float3 a, float3 b)
{
    return a + b;
}

float Sub(float a, float b)
{
    return a - b;
}

float3 Sub(float3 a, float3 b)
{
    return a - b;
}

float Mul(float a, float b)
{
    return a * b;
}

float3 Mul(float3 v, float s)
{
    return v * s;
}

float Div(float a, float b)
{
    return a / b;
}

float Sqrt(float a)
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
    return Div(Dot(normal, Sub(onPlane, origin)), Dot(normal, direction));
}

#endif
