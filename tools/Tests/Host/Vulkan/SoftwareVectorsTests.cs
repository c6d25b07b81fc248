using System;
using System.Linq;
using System.Runtime.Intrinsics;
using Glint.Vulkan;
using NUnit.Framework;

namespace Glint.Host.Tests.Vulkan;

public sealed class SoftwareVectorsTests
{
    [TestCase(null, true, ExpectedResult = true)]
    [TestCase("", true, ExpectedResult = true)]
    [TestCase("256", true, ExpectedResult = false)]
    [TestCase(null, false, ExpectedResult = false)]
    public bool Width_IsTheUsersOrTheFastest(string set, bool isFast) => SoftwareVectors.IsGain(set, isFast);

    // The driver's name for itself has the width: llvmpipe (LLVM 15.0.6, 512 bits).
    [Test]
    public void SoftwareDevice_OnAProcessorWithVectorsOf512Bits_HasThem()
    {
        var device = VulkanDevice.List().FirstOrDefault(each => each.Name.Contains("llvmpipe"));
        Assert.That(device, Is.Not.Null, "Mesa's software device is missing: apt-get install mesa-vulkan-drivers");
        if (SoftwareVectors.IsGain(Environment.GetEnvironmentVariable("LP_NATIVE_VECTOR_WIDTH"), Vector512.IsHardwareAccelerated))
            Assert.That(device.Name, Does.Contain("512 bits"));
    }
}
