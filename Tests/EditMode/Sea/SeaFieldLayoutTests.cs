using System.Linq;
using System.Runtime.InteropServices;
using NUnit.Framework;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>Structs and constants of a sea's field are the same in C# and HLSL.</summary>
    public sealed class SeaFieldLayoutTests
    {
        [Test]
        public void Structs_AreRowsOfSixteenBytes_OrHalfOfOne()
        {
            Assert.That(Marshal.SizeOf<SeaPoint>(), Is.EqualTo(8));
            Assert.That(Marshal.SizeOf<SeaWave>(), Is.EqualTo(16));
        }

        [Test]
        public void Structs_ReadByAKernel_HaveTheFieldsThatCSharpWrote()
        {
            var point = new SeaPoint { Height = 1, Acceleration = 2 };
            var wave = new SeaWave { Amplitude = float2(3, 4), Frequency = 5, Turns = 6 };
            using (var fields = new ShaderFields(TestKernels.SeaFieldLayout))
            {
                fields.Bind("_PointIn", point);
                fields.Bind("_WaveIn", wave);
                Assert.That(fields.Unpack(6), Is.EqualTo(Enumerable.Range(1, 6)
                    .Select(i => i == 6 ? (uint)i : asuint((float)i))));
            }
        }

        // A name without a counterpart fails on either side.
        [Test]
        public void Constants_OfTheKernels_AreThoseOfCSharp()
        {
            var constants = ShaderConstants.Of("SeaField.hlsl");
            Assert.That(constants, Is.EquivalentTo(new System.Collections.Generic.Dictionary<string, double>
            {
                ["SEA_SIDE"] = SeaField.Side, ["SEA_LEVELS"] = SeaField.Levels,
                ["SEA_BOUNDS"] = SeaField.BoundsOfATile, ["SEA_CASCADES"] = SeaField.MaxCascades
            }));
            Assert.That(ShaderConstants.Of("SeaBounds.hlsl")["SEA_BLOCK"], Is.EqualTo(SeaField.Block));
            Assert.That(1 << (SeaField.Levels - 1), Is.EqualTo(SeaField.Side), "the last level has one cell");
            Assert.That(SeaField.BoundsOfATile,
                Is.EqualTo(Enumerable.Range(0, SeaField.Levels).Sum(level => 1 << (2 * level))));
        }
    }
}
