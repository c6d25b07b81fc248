#ifndef GLINT_TUBE_KERNELS
#define GLINT_TUBE_KERNELS

#if defined(GLINT_STAGE)
#include "TubeStages.hlsl"
#elif defined(GLINT_ARITHMETIC)
#include "Arithmetic.hlsl"
#elif defined(GLINT_SUM_TUBES)
#include "TubeSums.hlsl"
#elif defined(GLINT_BANDS)
#include "TubeBands.hlsl"
#elif defined(GLINT_BISECT)
#include "TubeBisect.hlsl"
#elif defined(GLINT_AMPLITUDE)
#if defined(GLINT_POINTS)
#include "AmplitudePoints.hlsl"
#elif defined(GLINT_CELLS)
#include "AmplitudeCells.hlsl"
#elif defined(GLINT_BORDER_RAYS)
#include "AmplitudeRays.hlsl"
#else
#include "AmplitudeBorders.hlsl"
#endif
#elif defined(GLINT_CORNERS)
#include "TubeCorners.hlsl"
#elif defined(GLINT_CELLS)
#include "TubeCells.hlsl"
#elif defined(GLINT_REVEALS)
#include "TubeReveals.hlsl"
#elif defined(GLINT_OUTLINES)
#include "TubeOutlines.hlsl"
#elif defined(GLINT_SHADOWS)
#include "TubeShadows.hlsl"
#elif defined(GLINT_IMAGES)
#include "TubeImages.hlsl"
#elif defined(GLINT_CENTRES)
#include "TubeCentres.hlsl"
#elif defined(GLINT_SEA)
#include "SeaFacets.hlsl"
#elif defined(GLINT_SEA_LIGHTS)
#include "SeaLights.hlsl"
#elif defined(GLINT_FRINGES)
#include "TubeFringes.hlsl"
#elif defined(GLINT_UNIFORM_POINTS)
#include "TubePoints.hlsl"
#elif defined(GLINT_WHOLES)
#include "TubeWholes.hlsl"
#elif defined(GLINT_CHANGES)
#include "TubeChanges.hlsl"
#else
#include "TubeBorders.hlsl"
#endif

#endif
