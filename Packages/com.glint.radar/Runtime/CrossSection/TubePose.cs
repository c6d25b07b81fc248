using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    // GLINT_TUBE_POSE: Shaders/TubeBindings.hlsl, where the fields are explained.
    [StructLayout(LayoutKind.Sequential)]
    struct TubePose
    {
        public float4 Origin, OriginDx, OriginDy, Direction, DirectionDx, DirectionDy;
        public float3 SentV;
        public float CrossWeight;
        public float4 SentH, GridX, GridY, GridDepth;
        public uint4 Slice;
        public uint2 Cells, Blocks;
        public float2 Reference;
        public uint FirstCorner;
        public float OriginDepth, RadarPhase, CellError;
        public uint MaxLevel, MaxBisections;

        /// <summary>A pose of which no cell is traced.</summary>
        /// <param name="blocks">Of the cover.</param>
        public TubePose(CrossSectionPose pose, TubeGrid grid, int2 blocks)
        {
            this = new TubePose(grid.Rays, grid.Cells);
            (SentV, CrossWeight, SentH) = ((float3)pose.Radar.Up, 1, RowOf(pose.Radar.Right));
            var toCell = grid.ToCell();
            GridX = RowOf(toCell[0].Vector, toCell[0].Constant);
            GridY = RowOf(toCell[1].Vector, toCell[1].Constant);
            GridDepth = RowOf(toCell[2].Vector, toCell[2].Constant);
            Blocks = (uint2)blocks;
            RadarPhase = (float)grid.RadarPhaseOf(pose);
        }

        /// <summary>What an amplitude needs of it.</summary>
        /// <param name="cells">Base cells of the grid.</param>
        public TubePose(RayGrid rays, int2 cells)
        {
            this = default;
            (Origin, OriginDx, OriginDy) = (RowOf(rays.Origin), RowOf(rays.OriginDx), RowOf(rays.OriginDy));
            (Direction, DirectionDx, DirectionDy) =
                (RowOf(rays.Direction), RowOf(rays.DirectionDx), RowOf(rays.DirectionDy));
            Slice.z = 1;
            Cells = (uint2)cells;
            Reference = new float2(rays.ReferencePixel.x, rays.ReferencePixel.y);
            OriginDepth = (float)rays.OriginDepth;
        }

        /// <summary>
        /// Sets the base cells of each pose that a dispatch traces, and where they and their corners lie in it. Returns how many.
        /// </summary>
        /// <param name="slices">Of each pose, the first cell and their number: whole rows, or a part of one.</param>
        public static (int Cells, int Corners) SetSlices(TubePose[] poses, IReadOnlyList<(long First, int Count)> slices)
        {
            int cells = 0, corners = 0;
            for (int i = 0; i < poses.Length; i++)
            {
                var (first, count) = slices[i];
                int across = Math.Max(1, Math.Min(count, (int)poses[i].Cells.x));
                poses[i].Slice = new uint4((uint)first, (uint)count, (uint)across, (uint)cells);
                poses[i].FirstCorner = (uint)corners;
                cells += count;
                corners += TubeKernels.CornersOf(count, (int)poses[i].Cells.x);
            }
            return (cells, corners);
        }

        /// <summary>A row of a vector and a number.</summary>
        public static float4 RowOf(double3 vector, double w = 0) => new float4((float3)vector, (float)w);
    }
}
