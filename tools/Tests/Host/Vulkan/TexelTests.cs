using System.IO;
using System.Linq;
using Glint.Vulkan;
using NUnit.Framework;

namespace Glint.Host.Tests.Vulkan;

/// <summary>
/// Kernels that can read a texel buffer give the same either way;
/// the structured form is the one that runs unless asked.
/// </summary>
[TestFixture(true)]
[TestFixture(false)]
public sealed class TexelTests
{
    readonly bool _texels;
    readonly bool _before = ShaderLibrary.UsesTexelBuffers;
    VulkanDevice _device;

    public TexelTests(bool texels) => _texels = texels;

    [SetUp]
    public void OpenDevice()
    {
        ShaderLibrary.UsesTexelBuffers = _texels;
        _device = VulkanDevice.Open();
    }

    [TearDown]
    public void CloseDevice()
    {
        ShaderLibrary.UsesTexelBuffers = _before;
        _device.Dispose();
    }

    [Test]
    public void Kernel_OfRows_GathersThem()
    {
        const int Count = 1003; // a prime of groups' ends
        uint[] rows = Enumerable.Range(0, 4 * Count).Select(i => 0xfedc0000u + (uint)i).ToArray();
        uint[] order = Enumerable.Range(0, Count).Select(i => (uint)((i * 7) % Count)).ToArray();
        using var program = Kernels.Create(_device, Kernels.Texels, "Gather");
        using var tree = Kernels.Buffer(_device, rows);
        using var places = Kernels.Buffer(_device, order);
        using var gathered = _device.CreateBuffer(16 * Count);

        _device.Dispatch(program, Kernels.Pack(program, ("_Count", (uint)Count)),
            Kernels.Bind(("_Rows", tree), ("_Order", places), ("_Gathered", gathered)), Count / 32 + 1, 1, 1);

        var slot = program.Slots.Single(candidate => candidate.Name == "_Rows");
        Assert.That((slot.IsTexel, slot.Stride, slot.Element, slot.Writable),
            Is.EqualTo((_texels, 16, "uint4", false)));
        var expected = order.SelectMany((row, i) => Enumerable.Range(0, 4)
            .Select(part => rows[4 * row + part] + (part == 3 ? (uint)i : 0)));
        Assert.That(Kernels.Read<uint>(gathered), Is.EqualTo(expected));
    }

    [Test]
    public void Kernel_OfFifteenBuffers_ReadsEachOfThem()
    {
        using var program = Kernels.Create(_device, Kernels.Texels, "Crowd");
        var buffers = program.Slots.ToDictionary(slot => slot.Name, slot =>
            Kernels.Buffer(_device, slot.Writable ? new uint[4] : [(uint)(slot.Name[^1] - '0') + 1, 0, 0, 0]));

        _device.Dispatch(program, [], buffers, 1, 1, 1);

        Assert.That(buffers.Count, Is.EqualTo(15));
        Assert.That(new[] { "_Out0", "_Out1", "_Out2" }.Select(name => Kernels.Read<uint>(buffers[name])[0]),
            Is.EqualTo(new[] { 4321u, 8765u, 4321u }));
    }

    [Test]
    public void Kernel_WithoutSuchBuffers_HasOneForm()
    {
        using var program = Kernels.Create(_device, Kernels.Arithmetic, "Add");
        Assert.That(program.Slots.Any(slot => slot.IsTexel), Is.False);
        string folder = Path.Combine(System.AppContext.BaseDirectory, "shaders", Kernels.Arithmetic);
        Assert.That(Directory.GetFiles(folder, "*.texel.spv"), Is.Empty);
    }

    [Test]
    public void TexelView_OfABufferBelowOneElement_IsRefused()
    {
        using var buffer = _device.CreateBuffer(12);
        Assert.That(Assert.Throws<VulkanException>(() => _ = buffer.TexelView).Message,
            Does.Contain("12 bytes").And.Contain("GLINT_TEXEL_BUFFERS"));
    }
}
