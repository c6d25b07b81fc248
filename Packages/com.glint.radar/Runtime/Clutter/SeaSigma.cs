using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>Inputs of Shaders/SeaSigma.hlsl: what facets of a sea scatter back.</summary>
    static class SeaSigma
    {
        /// <summary>Writes a table of facets.</summary>
        public static void Upload(FacetTable table, DeviceBuffer<float4> target) =>
            target.Upload(Enumerable.Range(0, table.Values.Length / 4).Select(i => new float4(table.Values[4 * i],
                table.Values[4 * i + 1], table.Values[4 * i + 2], table.Values[4 * i + 3])).ToArray());

        /// <summary>Sets the mirror points of the waves that the facets leave out.</summary>
        public static void SetMirrorPoints(ComputeShader shader, FacetTable table)
        {
            double2 variance = table.Unresolved;
            double determinant = variance.x * variance.y - table.Covariance * table.Covariance;
            shader.SetVector(SeaIDs._SeaMirror, !(variance.x > 0 && determinant > 0) ? Vector4.zero : new Vector4(
                (float)(variance.y / (2 * determinant)), (float)(variance.x / (2 * determinant)),
                (float)(-table.Covariance / (2 * determinant)),
                (float)(table.MirrorPower / (2 * Math.Sqrt(determinant)))));
        }
    }
}
