using System;
using System.IO;
using System.Linq;
using Glint.Vulkan;
using NUnit.Framework;

namespace Glint.Host.Tests.Vulkan;

/// <summary>What a buffer of a device takes that shares the process's memory. On a GPU buffers are the device's own.</summary>
public sealed class HostMemoryTests
{
    // Every device takes buffers of this size.
    const long Bytes = 1L << 27, Page = 4096;

    [TestCase(1, 4096)]
    [TestCase(4096, 4096)]
    [TestCase(100_000, 65536)]
    public void Reserved_IsAlignedAndZero(int bytes, int alignment)
    {
        using var memory = new HostMemory((ulong)bytes, (ulong)alignment);
        unsafe
        {
            Assert.That((ulong)memory.Data % (ulong)alignment, Is.Zero);
            Assert.That(memory.Bytes, Is.GreaterThanOrEqualTo(bytes).And.LessThan(bytes + alignment));
            Assert.That(memory.Bytes % (ulong)alignment, Is.Zero);
            Assert.That(new ReadOnlySpan<byte>(memory.Data, (int)memory.Bytes).IndexOfAnyExcept((byte)0), Is.EqualTo(-1));
        }
    }

    // With large pages, by the environment, a page is 2 MB.
    [Test]
    public void Buffer_OfASoftwareDevice_TakesMemoryOnlyWhereItIsUsed()
    {
        var cpu = VulkanDevice.List().FirstOrDefault(device => device.Type == "CPU");
        Assert.That(cpu, Is.Not.Null, "Mesa's software device is missing: apt-get install mesa-vulkan-drivers");
        using var device = VulkanDevice.Open($"{cpu.Index}");
        long before = Resident();
        using var buffer = device.CreateBuffer(Bytes);
        buffer.Write([1, 2, 3, 4], Bytes / 2);
        var read = new byte[8];
        buffer.Read(read, Bytes / 2 - 4);
        Assert.That(read, Is.EqualTo(new byte[] { 0, 0, 0, 0, 1, 2, 3, 4 }));
        Assert.That(Resident() - before, Is.LessThan(Bytes / 8));
    }

    // Second number of statm: pages in memory.
    static long Resident() => Page * long.Parse(File.ReadAllText("/proc/self/statm").Split(' ')[1]);
}
