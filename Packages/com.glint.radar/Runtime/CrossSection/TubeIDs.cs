using UnityEngine;

namespace Glint
{
    // Names as in Shaders/TubeBindings.hlsl, TubeStages.hlsl, RevealedCells.hlsl, TubeShadows.hlsl, TubeImages.hlsl,
    // TubeFringes.hlsl, TubePoints.hlsl and TubeSums.hlsl.
    static class TubeIDs
    {
        public static readonly int _Facets = Shader.PropertyToID("_Facets");
        public static readonly int _NormalFields = Shader.PropertyToID("_NormalFields");
        public static readonly int _InstanceFacets = Shader.PropertyToID("_InstanceFacets");
        public static readonly int _Motions = Shader.PropertyToID("_Motions");
        public static readonly int _IsMoving = Shader.PropertyToID("_IsMoving");
        public static readonly int _TubeExtras = Shader.PropertyToID("_TubeExtras");
        public static readonly int _ExtraRows = Shader.PropertyToID("_ExtraRows");
        public static readonly int _Reflections = Shader.PropertyToID("_Reflections");
        public static readonly int _Receivers = Shader.PropertyToID("_Receivers");
        public static readonly int _ReceiverCount = Shader.PropertyToID("_ReceiverCount");
        public static readonly int _SlotCount = Shader.PropertyToID("_SlotCount");
        public static readonly int _IsMonostatic = Shader.PropertyToID("_IsMonostatic");
        public static readonly int _IsNear = Shader.PropertyToID("_IsNear");
        public static readonly int _Range = Shader.PropertyToID("_Range");
        public static readonly int _WaveNumber = Shader.PropertyToID("_WaveNumber");
        public static readonly int _FadesShadows = Shader.PropertyToID("_FadesShadows");
        public static readonly int _OnlyBounce = Shader.PropertyToID("_OnlyBounce");
        public static readonly int _Poses = Shader.PropertyToID("_Poses");
        public static readonly int _PoseCount = Shader.PropertyToID("_PoseCount");
        public static readonly int _BaseCounts = Shader.PropertyToID("_BaseCounts");
        public static readonly int _ListCapacity = Shader.PropertyToID("_ListCapacity");
        public static readonly int _Round = Shader.PropertyToID("_Round");
        public static readonly int _FrequencyCount = Shader.PropertyToID("_FrequencyCount");
        public static readonly int _WaveNumbers = Shader.PropertyToID("_WaveNumbers");
        public static readonly int _Tubes = Shader.PropertyToID("_Tubes");
        public static readonly int _TubeCells = Shader.PropertyToID("_TubeCells");
        public static readonly int _NextCells = Shader.PropertyToID("_NextCells");
        public static readonly int _CornersBefore = Shader.PropertyToID("_CornersBefore");
        public static readonly int _Centres = Shader.PropertyToID("_Centres");
        public static readonly int _Outlines = Shader.PropertyToID("_Outlines");
        public static readonly int _Borders = Shader.PropertyToID("_Borders");
        public static readonly int _PointsAcross = Shader.PropertyToID("_PointsAcross");
        public static readonly int _FirstPoint = Shader.PropertyToID("_FirstPoint");
        public static readonly int _ClearedWords = Shader.PropertyToID("_ClearedWords");
        public static readonly int _Corners = Shader.PropertyToID("_Corners");
        public static readonly int _FrequencyGroups = Shader.PropertyToID("_FrequencyGroups");
        public static readonly int _FrequenciesAGroup = Shader.PropertyToID("_FrequenciesAGroup");
        public static readonly int _Bands = Shader.PropertyToID("_Bands");
        public static readonly int _SumCopies = Shader.PropertyToID("_SumCopies");
        public static readonly int _UnitsPerMetre = Shader.PropertyToID("_UnitsPerMetre");
        public static readonly int _UnitsPerSquareMetre = Shader.PropertyToID("_UnitsPerSquareMetre");
        public static readonly int _Vertices = Shader.PropertyToID("_Vertices");
        public static readonly int _VertexCount = Shader.PropertyToID("_VertexCount");
        public static readonly int _Sides = Shader.PropertyToID("_Sides");
        public static readonly int _SideCount = Shader.PropertyToID("_SideCount");
        public static readonly int _LinkCapacity = Shader.PropertyToID("_LinkCapacity");
        public static readonly int _LineCapacity = Shader.PropertyToID("_LineCapacity");
        public static readonly int _Silhouettes = Shader.PropertyToID("_Silhouettes");
        public static readonly int _SilhouetteRange = Shader.PropertyToID("_SilhouetteRange");
        public static readonly int _Mirrors = Shader.PropertyToID("_Mirrors");
        public static readonly int _MirrorCount = Shader.PropertyToID("_MirrorCount");
        public static readonly int _OutlinePieces = Shader.PropertyToID("_OutlinePieces");
        public static readonly int _OutlinePieceCount = Shader.PropertyToID("_OutlinePieceCount");
        public static readonly int _Marks = Shader.PropertyToID("_Marks");
        public static readonly int _WrittenMarks = Shader.PropertyToID("_WrittenMarks");
        public static readonly int _Links = Shader.PropertyToID("_Links");
        public static readonly int _WrittenLinks = Shader.PropertyToID("_WrittenLinks");
        public static readonly int _TriangleCount = Shader.PropertyToID("_TriangleCount");
        public static readonly int _PlacedCount = Shader.PropertyToID("_PlacedCount");
        public static readonly int _Spheres = Shader.PropertyToID("_Spheres");
        public static readonly int _Places = Shader.PropertyToID("_Places");
        public static readonly int _MarkWords = Shader.PropertyToID("_MarkWords");
        public static readonly int _EdgePieces = Shader.PropertyToID("_EdgePieces");
        public static readonly int _EdgeRange = Shader.PropertyToID("_EdgeRange");
        public static readonly int _EdgeOffset = Shader.PropertyToID("_EdgeOffset");
        public static readonly int _TubeParts = Shader.PropertyToID("_TubeParts");
        public static readonly int _HasParts = Shader.PropertyToID("_HasParts");
        public static readonly int _Parts = Shader.PropertyToID("_Parts");
        public static readonly int _Revealed = Shader.PropertyToID("_Revealed");
        public static readonly int _WrittenRevealed = Shader.PropertyToID("_WrittenRevealed");
        public static readonly int _RevealedWords = Shader.PropertyToID("_RevealedWords");
        public static readonly int _RevealedByNow = Shader.PropertyToID("_RevealedByNow");
        public static readonly int _BeginningCount = Shader.PropertyToID("_BeginningCount");
        public static readonly int _Beginning = Shader.PropertyToID("_Beginning");
        public static readonly int _BisectSteps = Shader.PropertyToID("_BisectSteps");
    }
}
