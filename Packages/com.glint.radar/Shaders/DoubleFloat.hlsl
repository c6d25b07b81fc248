#ifndef GLINT_DOUBLE_FLOAT
#define GLINT_DOUBLE_FLOAT

// Double-float arithmetic: a number is the unevaluated sum of two float32, accurate to about 45 bits. Shader model 5.0
// has neither double on all devices nor fused multiply-add. After Dekker 1971, Knuth, and Li et al. 2002. Every step is
// "precise": otherwise FXC simplifies a + b - a to b, which silently removes the error terms. A step has a variable of
// its own, because glslang's "precise" ends at the arguments of a function: what is computed there may be fused.

struct DoubleFloat
{
    float Hi;             // the number rounded to float32
    float Lo;             // the rounding error
};

struct DoubleFloat3
{
    DoubleFloat X, Y, Z;
};

DoubleFloat MakeDoubleFloat(float hi, float lo)
{
    DoubleFloat value;
    value.Hi = hi;
    value.Lo = lo;
    return value;
}

DoubleFloat3 MakeDoubleFloat3(DoubleFloat x, DoubleFloat y, DoubleFloat z)
{
    DoubleFloat3 v;
    v.X = x;
    v.Y = y;
    v.Z = z;
    return v;
}

float RoundedSum(float a, float b)
{
    precise float sum = a + b;
    return sum;
}

// a + b, exact.
DoubleFloat TwoSum(float a, float b)
{
    precise float sum = a + b;
    precise float ofB = sum - a;
    precise float lo = (a - (sum - ofB)) + (b - ofB);
    return MakeDoubleFloat(sum, lo);
}

// a + b, exact if |a| >= |b| or a is 0.
DoubleFloat QuickTwoSum(float a, float b)
{
    precise float sum = a + b;
    precise float lo = b - (sum - a);
    return MakeDoubleFloat(sum, lo);
}

// A number without its lower 12 bits.
float Upper(float a)
{
    precise float scaled = 4097.0 * a;
    precise float upper = scaled - (scaled - a);
    return upper;
}

// a * b, exact. Not every device rounds mad once: kernels with GLINT_FUSED are taken where the self-test finds that it does.
DoubleFloat TwoProd(float a, float b)
{
#ifdef GLINT_FUSED
    precise float product = a * b;
    precise float lo = mad(a, b, -product);
#else
    float upperA = Upper(a), upperB = Upper(b);
    precise float lowerA = a - upperA;
    precise float lowerB = b - upperB;
    precise float product = a * b;
    precise float lo = ((upperA * upperB - product) + upperA * lowerB + lowerA * upperB) + lowerA * lowerB;
#endif
    return MakeDoubleFloat(product, lo);
}

DoubleFloat Add(DoubleFloat a, DoubleFloat b)
{
    DoubleFloat sum = TwoSum(a.Hi, b.Hi);
    return TwoSum(sum.Hi, RoundedSum(sum.Lo, RoundedSum(a.Lo, b.Lo)));
}

DoubleFloat Sub(DoubleFloat a, DoubleFloat b)
{
    return Add(a, MakeDoubleFloat(-b.Hi, -b.Lo));
}

DoubleFloat Mul(DoubleFloat a, DoubleFloat b)
{
    DoubleFloat product = TwoProd(a.Hi, b.Hi);
    precise float lows = a.Hi * b.Lo + a.Lo * b.Hi;
    return QuickTwoSum(product.Hi, RoundedSum(product.Lo, lows));
}

DoubleFloat Mul(DoubleFloat a, float b)
{
    DoubleFloat product = TwoProd(a.Hi, b);
    precise float lo = a.Lo * b;
    return QuickTwoSum(product.Hi, RoundedSum(product.Lo, lo));
}

// Long division with two digits; a device's own division may be off by some steps.
DoubleFloat Div(DoubleFloat a, DoubleFloat b)
{
    precise float first = a.Hi / b.Hi;
    precise float second = Sub(a, Mul(b, first)).Hi / b.Hi;
    return TwoSum(first, second);
}

// Square root of a positive number: the device's own, and a Newton step.
DoubleFloat Sqrt(DoubleFloat a)
{
    precise float root = sqrt(a.Hi);
    precise float rest = Sub(a, TwoProd(root, root)).Hi / (2.0 * root);
    return TwoSum(root, rest);
}

float Rounded(DoubleFloat a)
{
    return a.Hi;
}

float3 Rounded(DoubleFloat3 v)
{
    return float3(v.X.Hi, v.Y.Hi, v.Z.Hi);
}

DoubleFloat3 Add(DoubleFloat3 a, DoubleFloat3 b)
{
    return MakeDoubleFloat3(Add(a.X, b.X), Add(a.Y, b.Y), Add(a.Z, b.Z));
}

DoubleFloat3 Sub(DoubleFloat3 a, DoubleFloat3 b)
{
    return MakeDoubleFloat3(Sub(a.X, b.X), Sub(a.Y, b.Y), Sub(a.Z, b.Z));
}

// a - b, exact.
DoubleFloat3 Difference(float3 a, float3 b)
{
    return MakeDoubleFloat3(TwoSum(a.x, -b.x), TwoSum(a.y, -b.y), TwoSum(a.z, -b.z));
}

DoubleFloat3 Mul(DoubleFloat3 v, DoubleFloat s)
{
    return MakeDoubleFloat3(Mul(v.X, s), Mul(v.Y, s), Mul(v.Z, s));
}

DoubleFloat3 Mul(DoubleFloat3 v, float s)
{
    return MakeDoubleFloat3(Mul(v.X, s), Mul(v.Y, s), Mul(v.Z, s));
}

DoubleFloat Dot(DoubleFloat3 a, DoubleFloat3 b)
{
    DoubleFloat x = TwoProd(a.X.Hi, b.X.Hi), y = TwoProd(a.Y.Hi, b.Y.Hi), z = TwoProd(a.Z.Hi, b.Z.Hi);
    precise float lows =
        (a.X.Hi * b.X.Lo + a.X.Lo * b.X.Hi) + (a.Y.Hi * b.Y.Lo + a.Y.Lo * b.Y.Hi) + (a.Z.Hi * b.Z.Lo + a.Z.Lo * b.Z.Hi);
    DoubleFloat xy = TwoSum(x.Hi, y.Hi);
    DoubleFloat xyz = TwoSum(xy.Hi, z.Hi);
    precise float lo = (xy.Lo + xyz.Lo) + ((x.Lo + y.Lo) + (z.Lo + lows));
    return TwoSum(xyz.Hi, lo);
}

DoubleFloat3 Cross(DoubleFloat3 a, DoubleFloat3 b)
{
    return MakeDoubleFloat3(
        Sub(Mul(a.Y, b.Z), Mul(a.Z, b.Y)),
        Sub(Mul(a.Z, b.X), Mul(a.X, b.Z)),
        Sub(Mul(a.X, b.Y), Mul(a.Y, b.X)));
}

#endif
