#ifndef GLINT_SCREEN
#define GLINT_SCREEN

// Names that all kernels of a radar screen share: Core/Screen/ScreenGeometry.cs.

static const float ECHO_UNITS = 64.0;      // of a sum of echoes, in the root of the noise's power

uint4 _ScreenSize;                         // spokes, a power of two; cells; spokes beside a spoke in the beam; seed
uint4 _ScreenSlice;                        // spokes of this dispatch: first, number, turn of the first

// A spoke of this dispatch, as a place in a turn.
uint SpokeAt(uint number)
{
    return (_ScreenSlice.x + number) & (_ScreenSize.x - 1);
}

bool IsSpokeInSlice(uint spoke)
{
    return ((spoke - _ScreenSlice.x) & (_ScreenSize.x - 1)) < _ScreenSlice.y;
}

// The turn of a spoke of this dispatch, counted from the first.
int TurnAt(uint number)
{
    return (int)(_ScreenSlice.z + (_ScreenSlice.x + number) / _ScreenSize.x);
}

#endif
