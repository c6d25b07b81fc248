using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>The self-test of the device's arithmetic: it passes here, and finds fast math.</summary>
    public sealed class DeviceArithmeticTests
    {
        [Test]
        public void Check_OnThisDevice_Passes() =>
            Assert.That(DeviceArithmetic.FirstWrong(TestKernels.Trace, "Arithmetic"), Is.Null);

        // The shaders of ray tubes check themselves: a scene may have no other.
        [Test]
        public void Check_OfRayTubes_Passes()
        {
            Assert.That(DeviceArithmetic.FirstWrong(TestKernels.Tubes, "Arithmetic"), Is.Null);
            Assert.That(DeviceArithmetic.FirstWrong(TestKernels.Amplitude, "Arithmetic"), Is.Null);
        }

        [TestCase("NotPrecise", "TwoSum")]
        [TestCase("FoldedSums", "TwoSum")]
        [TestCase("FusedProducts", "TwoProd")]
        [TestCase("FusedSides", "SideOf")]
        [TestCase("RoundedTwice", "TwoProd")]
        public void FirstWrong_WithFastMath_NamesTheOperation(string kernel, string operation) =>
            Assert.That(DeviceArithmetic.FirstWrong(TestKernels.FastMath, kernel),
                Does.StartWith(operation + " gives "));
    }
}
