#ifndef GLINT_STAGES
#define GLINT_STAGES

#include "SubRayChoice.hlsl"

// The small kernels of a slice, between those that trace.

uint _TraceGroup;                       // threads of a group of the kernels that trace and refine
uint _RefineGroup;
RWByteAddressBuffer _Arguments;         // groups of the indirect dispatches

// Clears sums and counts.
[numthreads(GLINT_GROUP, 1, 1)]
void ClearSums(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint word = IndexOf(group, thread);
    if (word < RECEIVED_RAYS)
        _Sums[word] = 0;
}

void StoreGroups(uint offset, uint threads, uint groupSize)
{
    uint groups = (threads + groupSize - 1) / groupSize;
    _Arguments.Store3(offset, uint3(min(groups, GROUPS_A_ROW), (groups + GROUPS_A_ROW - 1) / GROUPS_A_ROW, 1));
}

// Groups of the indirect dispatches, by the counts so far.
[numthreads(1, 1, 1)]
void CountGroups()
{
    uint candidates = CandidateThreads(CandidateCounts(false));
    StoreGroups(REFINE_ARGUMENTS, candidates, _RefineGroup);
    // The choice of pixels is wrong while candidates are left for another dispatch; the processor then chooses.
    bool isChoice = candidates < MAX_REFINED && _Sums[COUNT_CHOSEN] <= MAX_CHOSEN;
    StoreGroups(SUB_RAY_ARGUMENTS, isChoice ? _Sums[COUNT_CHOSEN] * SUB_RAYS * SUB_RAYS : 0, _TraceGroup);
    StoreGroups(REFINE_SUB_RAY_ARGUMENTS, CandidateThreads(CandidateCounts(true)), _RefineGroup);
}

// Chooses the pixels that get sub-rays: one thread a candidate.
[numthreads(GLINT_GROUP, 1, 1)]
void ChooseSubRays(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint entry = CandidateOf(IndexOf(group, thread));
    if (entry == NO_CANDIDATE)
        return;
    uint pixel = _Candidates[entry].x;
    if (pixel != NO_PIXEL)
        ChooseAround(pixel);
}

// Removes the lengths of the received rays: one thread a candidate.
[numthreads(GLINT_GROUP, 1, 1)]
void ForgetLengths(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint entry = CandidateOf(IndexOf(group, thread));
    if (entry == NO_CANDIDATE)
        return;
    uint pixel = _Candidates[entry].x;
    if (pixel != NO_PIXEL)
        _Lengths[InRegion(pixel)] = NO_LENGTH;
}

#endif
