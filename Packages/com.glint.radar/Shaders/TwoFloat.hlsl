#ifndef GLINT_TWO_FLOAT
#define GLINT_TWO_FLOAT

// Numbers of about 45 bits: the unevaluated sum of two float32,
// as shader model 5.0 has no double on all devices and no fused multiply-add.
// (After Dekker 1971, Knuth, and Li et al. 2002.) Every step is "precise": without it FXC takes a + b - a for b,
// and the errors that this is all about are gone, without a word.

struct Two
{
    float Hi;             // the number, rounded to float32
    float Lo;             // what the rounding left out
};

struct Two3
{
    Two X, Y, Z;
};

Two MakeTwo(float hi, float lo)
{
    Two two;
    two.Hi = hi;
    two.Lo = lo;
    return two;
}

Two3 MakeTwo3(Two x, Two y, Two z)
{
    Two3 v;
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

// a + b, exactly.
Two ExactSum(float a, float b)
{
    precise float sum = a + b;
    precise float ofB = sum - a;
    precise float rest = (a - (sum - ofB)) + (b - ofB);
    return MakeTwo(sum, rest);
}

// a + b, exactly, when a is the larger one or 0.
Two ExactSumInOrder(float a, float b)
{
    precise float sum = a + b;
    precise float rest = b - (sum - a);
    return MakeTwo(sum, rest);
}

// A number without its lower 12 bits.
float Upper(float a)
{
    precise float scaled = 4097.0 * a;
    precise float upper = scaled - (scaled - a);
    return upper;
}

// a * b, exactly.
Two ExactProduct(float a, float b)
{
    float upperA = Upper(a), upperB = Upper(b);
    precise float lowerA = a - upperA;
    precise float lowerB = b - upperB;
    precise float product = a * b;
    precise float rest = ((upperA * upperB - product) + upperA * lowerB + lowerA * upperB) + lowerA * lowerB;
    return MakeTwo(product, rest);
}

Two Plus(Two a, Two b)
{
    Two sum = ExactSum(a.Hi, b.Hi);
    return ExactSum(sum.Hi, RoundedSum(sum.Lo, a.Lo + b.Lo));
}

Two Minus(Two a, Two b)
{
    return Plus(a, MakeTwo(-b.Hi, -b.Lo));
}

Two Times(Two a, Two b)
{
    Two product = ExactProduct(a.Hi, b.Hi);
    return ExactSumInOrder(product.Hi, RoundedSum(product.Lo, a.Hi * b.Lo + a.Lo * b.Hi));
}

Two Times(Two a, float b)
{
    Two product = ExactProduct(a.Hi, b);
    return ExactSumInOrder(product.Hi, RoundedSum(product.Lo, a.Lo * b));
}

// Two digits of a long division: a device's own may be off by some steps.
Two Over(Two a, Two b)
{
    float first = a.Hi / b.Hi;
    return ExactSum(first, Minus(a, Times(b, first)).Hi / b.Hi);
}

// Square root of a positive number: a step of Newton's after the device's own.
Two Root(Two a)
{
    float root = sqrt(a.Hi);
    return ExactSum(root, Minus(a, ExactProduct(root, root)).Hi / (2.0 * root));
}

float Rounded(Two a)
{
    return a.Hi;
}

float3 Rounded(Two3 v)
{
    return float3(v.X.Hi, v.Y.Hi, v.Z.Hi);
}

Two3 Plus(Two3 a, Two3 b)
{
    return MakeTwo3(Plus(a.X, b.X), Plus(a.Y, b.Y), Plus(a.Z, b.Z));
}

Two3 Minus(Two3 a, Two3 b)
{
    return MakeTwo3(Minus(a.X, b.X), Minus(a.Y, b.Y), Minus(a.Z, b.Z));
}

// a - b, exactly.
Two3 Difference(float3 a, float3 b)
{
    return MakeTwo3(ExactSum(a.x, -b.x), ExactSum(a.y, -b.y), ExactSum(a.z, -b.z));
}

Two3 Times(Two3 v, Two s)
{
    return MakeTwo3(Times(v.X, s), Times(v.Y, s), Times(v.Z, s));
}

Two3 Times(Two3 v, float s)
{
    return MakeTwo3(Times(v.X, s), Times(v.Y, s), Times(v.Z, s));
}

Two Dot(Two3 a, Two3 b)
{
    Two x = ExactProduct(a.X.Hi, b.X.Hi), y = ExactProduct(a.Y.Hi, b.Y.Hi), z = ExactProduct(a.Z.Hi, b.Z.Hi);
    float rests =
        (a.X.Hi * b.X.Lo + a.X.Lo * b.X.Hi) + (a.Y.Hi * b.Y.Lo + a.Y.Lo * b.Y.Hi) + (a.Z.Hi * b.Z.Lo + a.Z.Lo * b.Z.Hi);
    Two two = ExactSum(x.Hi, y.Hi);
    Two three = ExactSum(two.Hi, z.Hi);
    return ExactSum(three.Hi, RoundedSum(two.Lo + three.Lo, (x.Lo + y.Lo) + (z.Lo + rests)));
}

Two3 Cross(Two3 a, Two3 b)
{
    return MakeTwo3(
        Minus(Times(a.Y, b.Z), Times(a.Z, b.Y)),
        Minus(Times(a.Z, b.X), Times(a.X, b.Z)),
        Minus(Times(a.X, b.Y), Times(a.Y, b.X)));
}

#endif
