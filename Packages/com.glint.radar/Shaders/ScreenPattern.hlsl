#ifndef GLINT_SCREEN_PATTERN
#define GLINT_SCREEN_PATTERN

// The antenna's pattern in elevation: Core/Screen/ScreenGeometry.cs.

static const uint ELEVATION_STEPS = 4096;

StructuredBuffer<float> _ElevationField;   // one way, at equal steps from straight down to straight up

// elevation: rad.
float ElevationField(float elevation)
{
    float place = saturate(2.0 * elevation / TWO_PI + 0.5) * ELEVATION_STEPS;
    uint step = min((uint)place, ELEVATION_STEPS - 1);
    return lerp(_ElevationField[step], _ElevationField[step + 1], place - step);
}

#endif
