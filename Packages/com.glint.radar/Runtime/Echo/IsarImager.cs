using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Threading.Tasks;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>Backprojection on the device: the image of <see cref="IsarTransform"/> in float32.</summary>
    public sealed class IsarImager : IDisposable
    {
        // Of a dispatch, which must end before the operating system's watchdog.
        const int LooksADispatch = 64;

        static readonly int s_looks = Shader.PropertyToID("_Looks"), s_profiles = Shader.PropertyToID("_Profiles"),
            s_image = Shader.PropertyToID("_Image"), s_size = Shader.PropertyToID("_ImageSize");

        readonly ComputeShader _shader;
        readonly int _kernel;
        readonly DeviceBuffer<IsarLook> _looks = new DeviceBuffer<IsarLook>("looks");
        readonly DeviceBuffer<float2> _profiles = new DeviceBuffer<float2>("cells of range profiles");
        readonly DeviceBuffer<float2> _image = new DeviceBuffer<float2>("pixels of an image");

        /// <param name="shader">Shaders/Backprojection.compute.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        /// <exception cref="GlintException">The device runs no kernels, or it is another shader.</exception>
        public IsarImager(ComputeShader shader, string owner = nameof(IsarImager))
        {
            DeviceCheck.Require(shader, "Backprojection", "Backproject", owner);
            (_shader, _kernel) = (shader, shader.FindKernel("Backproject"));
        }

        /// <summary>The image, row by row: rows are down range, columns cross range.</summary>
        /// <param name="profiles">Of each look of the transform.</param>
        /// <exception cref="GlintException">The device cannot hold image or profiles.</exception>
        public Complex[] Image(IsarTransform transform, IReadOnlyList<Complex[]> profiles)
        {
            int pixels = transform.Pixels, cells = profiles[0].Length;
            _image.Reserve((long)pixels * pixels);
            _shader.SetBuffer(_kernel, s_image, _image.Buffer);
            for (int first = 0; first < profiles.Count; first += LooksADispatch)
            {
                int count = Math.Min(LooksADispatch, profiles.Count - first);
                _looks.Upload(Enumerable.Range(first, count)
                    .Select(look => new IsarLook(transform.LookOf(look))).ToArray());
                _profiles.Upload(CellsOf(profiles, first, count));
                _shader.SetBuffer(_kernel, s_looks, _looks.Buffer);
                _shader.SetBuffer(_kernel, s_profiles, _profiles.Buffer);
                _shader.SetInts(s_size, pixels, cells, count, first > 0 ? 1 : 0);
                _shader.DispatchThreads(_kernel, (long)pixels * pixels);
            }
            var read = new float2[pixels * pixels];
            _image.ReadBack(read, read.Length);
            return Array.ConvertAll(read, value => new Complex(value.x, value.y));
        }

        static float2[] CellsOf(IReadOnlyList<Complex[]> profiles, int first, int count)
        {
            int cells = profiles[first].Length;
            var all = new float2[count * cells];
            Parallel.For(0, count, look =>
            {
                var profile = profiles[first + look];
                for (int i = 0; i < cells; i++)
                    all[look * cells + i] = new float2((float)profile[i].Real, (float)profile[i].Imaginary);
            });
            return all;
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _looks.Dispose();
            _profiles.Dispose();
            _image.Dispose();
        }
    }

    // GLINT_LOOK: Shaders/Backprojection.hlsl, where the fields are explained.
    [StructLayout(LayoutKind.Sequential)]
    struct IsarLook
    {
        public float4 Turns, Cells;
        public float2 CentreCell;
        public float Weight, Range;
        public float4 Bend;

        public IsarLook(LookSteps steps) : this()
        {
            float4 Steps(double down, double cross) =>
                new float4((float)down, DoubleFloat.Lo(down), (float)cross, DoubleFloat.Lo(cross));
            Turns = Steps(steps.TurnsAPixel * steps.AwayDown, steps.TurnsAPixel * steps.AwayCross);
            Cells = Steps(steps.CellsAPixel * steps.AwayDown, steps.CellsAPixel * steps.AwayCross);
            CentreCell = new float2((float)steps.CentreCell, DoubleFloat.Lo(steps.CentreCell));
            Weight = (float)steps.Weight;
            Range = double.IsPositiveInfinity(steps.Range) ? 0 : (float)steps.Range;
            Bend = (float4)new double4(steps.AwayDown, steps.AwayCross, steps.CellsAPixel, steps.TurnsAPixel);
        }
    }
}
