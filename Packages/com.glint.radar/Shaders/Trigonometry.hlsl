#ifndef GLINT_TRIGONOMETRY
#define GLINT_TRIGONOMETRY

static const float TWO_PI = 6.28318530717958647692;

// Cosine and sine of a fraction of a turn, to 1e-7; a device's own may be off by 5e-4. "precise" keeps compilers from
// turning the division into a multiplication and from fusing steps, which changes the last digit of some phasors.
float2 Phasor(float turns)
{
    uint quarter = (uint)(4.0 * turns + 0.5);
    precise float x = TWO_PI * (turns - 0.25 * quarter);
    precise float square = x * x;
    precise float sine =
        x * (1.0 + square * (-1.0 / 6.0 + square * (1.0 / 120.0 + square * (-1.0 / 5040.0 + square / 362880.0))));
    precise float cosine = 1.0 + square * (-0.5 + square * (1.0 / 24.0 + square * (-1.0 / 720.0 + square / 40320.0)));
    float2 phasor = (quarter & 1) == 0 ? float2(cosine, sine) : float2(-sine, cosine);
    return (quarter & 2) == 0 ? phasor : -phasor;
}

// Cosine and sine of an angle, rad.
float2 PhasorOf(float angle)
{
    float turns = angle / TWO_PI;
    return Phasor(turns - floor(turns));
}

// Product of two complex numbers.
float2 ComplexMul(float2 a, float2 b)
{
    return float2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

#endif
