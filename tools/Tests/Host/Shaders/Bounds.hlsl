#ifndef BOUNDS_INCLUDED
#define BOUNDS_INCLUDED

uint Count;

bool Inside(uint index)
{
    return index < Count;
}

#endif
