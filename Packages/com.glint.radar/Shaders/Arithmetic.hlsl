// Self-test of the device's arithmetic (Runtime/Tracing/DeviceArithmetic.cs): the operations whose rounding double-float
// numbers and watertight edges depend on. Operands come from a buffer: no compiler can evaluate them in advance.

#include "DoubleFloat.hlsl"
#include "Geometry.hlsl"

struct ArithmeticResult
{
    float2 Sum;            // TwoSum of x and y
    float2 SumInOrder;     // QuickTwoSum of x and y
    float2 Product;        // TwoProd of x and y
    float2 Quotient;       // Div of x + y and z + w
    float2 Root;           // Sqrt of x + y
    float RoundedSum;      // of x and y
    float Side;            // SideOf (x, y) and (z, w)
};

StructuredBuffer<float4> _Operands;
RWStructuredBuffer<ArithmeticResult> _Results;

float2 HiLo(DoubleFloat a)
{
    return float2(a.Hi, a.Lo);
}

[numthreads(64, 1, 1)]
void GLINT_KERNEL(uint3 thread : SV_DispatchThreadID)
{
    float4 n = _Operands[thread.x];
    DoubleFloat a = TwoSum(n.x, n.y), b = TwoSum(n.z, n.w);
    ArithmeticResult result;
    result.Sum = HiLo(a);
    result.SumInOrder = HiLo(QuickTwoSum(n.x, n.y));
    result.Product = HiLo(TwoProd(n.x, n.y));
    result.Quotient = HiLo(Div(a, b));
    result.Root = HiLo(Sqrt(a));
    result.RoundedSum = RoundedSum(n.x, n.y);
    result.Side = SideOf(float3(n.xy, 0.0), float3(n.zw, 0.0));
    _Results[thread.x] = result;
}
