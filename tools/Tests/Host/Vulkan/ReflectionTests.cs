using System.Linq;
using Glint.Vulkan;
using NUnit.Framework;

namespace Glint.Host.Tests.Vulkan;

public sealed class ReflectionTests
{
    VulkanDevice _device;

    [OneTimeSetUp] public void OpenDevice() => _device = VulkanDevice.Open();

    [OneTimeTearDown] public void CloseDevice() => _device.Dispose();

    [Test]
    public void Buffers_AreThoseUsed_ByTheirNamesInHlsl()
    {
        using var add = Kernels.Create(_device, Kernels.Arithmetic, "Add");
        using var scale = Kernels.Create(_device, Kernels.Arithmetic, "Scale");
        Assert.That(add.Buffers, Is.EquivalentTo(new[] { "Left", "Right", "Sum" }));
        Assert.That(scale.Buffers, Is.EquivalentTo(new[] { "Left", "Sum" }));
        Assert.That(add.Slots.Where(slot => slot.Writable).Select(slot => slot.Name), Is.EqualTo(new[] { "Sum" }));
    }

    [Test]
    public void GroupSize_IsNumThreads()
    {
        using var program = Kernels.Create(_device, Kernels.Arithmetic, "Scale");
        Assert.That(program.GroupSize, Is.EqualTo((8u, 4u, 2u)));
        Assert.That(program.Name, Is.EqualTo("Scale"));
    }

    [Test]
    public void Structs_OfLooseVectors_HaveTheStrideOfTheKernel()
    {
        using var program = Kernels.Create(_device, Kernels.Structs, "Loose");
        var corners = program.Slots.Single(slot => slot.Name == "Corners");
        Assert.That((corners.Stride, corners.Element), Is.EqualTo((32, "Corner")));
    }

    [TestCase("Real", 4, 1, 1, 0)]
    [TestCase("Pair", 8, 1, 2, 0)]
    [TestCase("Quad", 16, 1, 4, 0)]
    [TestCase("Reals", 36, 1, 1, 3)]    // stride of 16 bytes
    [TestCase("Quads", 32, 1, 4, 2)]
    [TestCase("Columns", 64, 4, 4, 0)]
    [TestCase("Matrices", 128, 4, 4, 2)]
    [TestCase("Affine", 60, 3, 4, 0)]   // four columns of three, 16 bytes each, the last unpadded
    public void Uniforms_HaveTheirShape(string name, int bytes, int rows, int columns, int length)
    {
        using var program = Kernels.Create(_device, Kernels.Uniforms, "Echo");
        var field = program.Uniforms[name];
        Assert.That((field.Bytes, field.Rows, field.Columns, field.ArrayLength),
            Is.EqualTo((bytes, rows, columns, length)));
    }

    [Test]
    public void Uniforms_OfEveryKind_ArriveInTheKernel()
    {
        float[] matrix = Count(16, 100), second = Count(16, 200), matrices = Count(32, 300),
            affineColumns = Count(16, 400);
        using var program = Kernels.Create(_device, Kernels.Uniforms, "Echo");
        using var output = _device.CreateBuffer(4 * 256);
        byte[] uniforms = Kernels.Pack(program,
            ("Real", 1.5f), ("Signed", -7), ("Unsigned", 9u), ("Yes", 1),
            ("Pair", Count(2, 10)), ("Triple", Count(3, 20)), ("Quad", Count(4, 30)), ("Cell", new[] { -1, -2, -3 }),
            ("Reals", new float[] { 40, 0, 0, 0, 41, 0, 0, 0, 42 }), ("Quads", Count(8, 50)),
            ("Columns", matrix), ("RowsFirst", second), ("Matrices", matrices), ("Affine", affineColumns[..15]),
            ("Inner", 60f), ("Mask", new[] { 61, 62, 63, 64 }));

        _device.Dispatch(program, uniforms, Kernels.Bind(("Out", output)), 1, 1, 1);

        float[] expected = new[]
        {
            [1.5f, -7, 9, 1], Count(2, 10), Count(3, 20), Count(4, 30), [-1, -2, -3], [40, 41, 42], Count(8, 50),
            Transposed(matrix, 4, 4), second, Transposed(matrices[..16], 4, 4),
            Transposed(matrices[16..], 4, 4), Transposed(affineColumns, 3, 4),
            [60, 61, 62, 63, 64], [matrix[12]],
        }.SelectMany(values => values).ToArray();
        Assert.That(Kernels.Read<float>(output)[..expected.Length], Is.EqualTo(expected));
    }

    /// <summary>Values in row order, from columns four floats apart.</summary>
    static float[] Transposed(float[] columns, int rows, int count) =>
        Enumerable.Range(0, rows * count).Select(i => columns[i % count * 4 + i / count]).ToArray();

    static float[] Count(int length, int first) => Enumerable.Range(first, length).Select(i => (float)i).ToArray();
}
