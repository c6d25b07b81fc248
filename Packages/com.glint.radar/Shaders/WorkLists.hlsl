#ifndef GLINT_WORK_LISTS
#define GLINT_WORK_LISTS

#include "Bindings.hlsl"

// The lists that one kernel of a slice leaves to the next, on the device. Their counts are words of _Sums.

// Threads of a group; results do not depend on it.
#ifndef GLINT_GROUP
#define GLINT_GROUP 64
#endif

static const uint NO_CANDIDATE = 0xffffffff;

// Whether the ray of a column and row is traced.
bool IsInRegion(int2 at)
{
    return at.x >= (int)_Region.x && at.x < (int)_Region.y && at.y >= (int)_Region.z && at.y < (int)_Region.w;
}

// Element of a pixel in _Lengths.
uint InRegion(uint pixel)
{
    return pixel % _RaysAcross - _Region.x + (pixel / _RaysAcross - _Region.z) * (_Region.y - _Region.x);
}

uint IndexOf(uint3 group, uint thread)
{
    return (group.x + group.y * GROUPS_A_ROW) * GLINT_GROUP + thread;
}

// First of the candidates to search.
uint SearchedList()
{
    return _HasSubRays != 0 ? _KnownCapacity.y : _KnownCapacity.x;
}

// Whether the triangles of a candidate are in _Met.
bool HasMet(uint entry)
{
    return entry < 2 * SearchedList();
}

// Candidates of this slice, or of its sub-rays: those known, and those to search.
uint2 CandidateCounts(bool areSubRays)
{
    return areSubRays ? uint2(min(_Sums[COUNT_SUB_KNOWN], _KnownCapacity.y), _Sums[COUNT_SUB_SEARCHED])
        : uint2(min(_Sums[COUNT_KNOWN], _KnownCapacity.x), _Sums[COUNT_SEARCHED]);
}

// Threads for the known candidates.
uint KnownThreads(uint known)
{
    return (known + CANDIDATE_PADDING - 1) / CANDIDATE_PADDING * CANDIDATE_PADDING;
}

// Threads a candidate to search. Those of a wave wait for each other's steps. As long as they do not fill the device,
// they take less time if each has several threads, of which one works.
uint SpreadOf(uint searched)
{
    return clamp(SPREAD_THREADS / max(searched, 1), 1, _MaxSpread);
}

// Threads of a dispatch that takes the known candidates and, up to the maximum, those to search.
uint CandidateThreads(uint2 counts)
{
    return min(KnownThreads(counts.x) + counts.y * SpreadOf(counts.y), MAX_REFINED);
}

// The candidate of a thread; NO_CANDIDATE if it has none. Later dispatches take the rest of those to search.
uint CandidateOf(uint index)
{
    uint2 counts = CandidateCounts(_HasSubRays != 0);
    if (_FirstSearched > 0)
        return index < min(counts.y - _FirstSearched, MAX_REFINED) ? SearchedList() + _FirstSearched + index : NO_CANDIDATE;
    if (index < counts.x)
        return index;
    uint known = KnownThreads(counts.x), searched = index - known, spread = SpreadOf(counts.y);
    return index >= known && index < CandidateThreads(counts) && searched % spread == 0
        ? SearchedList() + searched / spread
        : NO_CANDIDATE;
}

#endif
