using System;
using System.IO;
using Glint.Vulkan;
using NUnit.Framework;

namespace Glint.Host.Tests.Vulkan;

public sealed class RefusalTests
{
    VulkanDevice _device;

    [OneTimeSetUp] public void OpenDevice() => _device = VulkanDevice.Open();

    [OneTimeTearDown] public void CloseDevice() => _device.Dispose();

    [Test]
    public void Selector_IndexOrPartOfName_OpensThatDevice()
    {
        var info = VulkanDevice.List()[0];
        foreach (string selector in new[] { "0", info.Name[1..4].ToUpperInvariant(), info.Name.ToLowerInvariant() })
        {
            using var device = VulkanDevice.Open(selector);
            Assert.That(device.Info.Name, Does.Contain(info.Name).IgnoreCase, selector);
        }
    }

    [Test]
    public void Selector_OfNoDevice_ListsThoseThereAre()
    {
        var error = Assert.Throws<VulkanException>(() => VulkanDevice.Open("Voodoo 2"));
        Assert.That(error.Message, Does.StartWith("no Vulkan device \"Voodoo 2\"").And.Contain(_device.Info.Name));
    }

    // Names of devices have numbers, such as the versions in "llvmpipe (LLVM 15.0.6, 256 bits)".
    [TestCase("256")]
    [TestCase("99999999999")]
    public void Selector_OfDigits_IsAnIndex(string selector) =>
        Assert.That(Assert.Throws<VulkanException>(() => VulkanDevice.Open(selector)).Message,
            Does.StartWith($"no Vulkan device \"{selector}\"; choose an index or a part of a name of: 0 "));

    [Test]
    public void NoDevice_WithAVariableThatHidesTheDrivers_BlamesTheVariable()
    {
        string present = typeof(VulkanDevice).Assembly.Location;
        string Blame(params (string name, string value)[] set) =>
            DriverVariable.Blame(name => Array.Find(set, pair => pair.name == name).value);

        Assert.That(Blame(("VK_DRIVER_FILES", "/nope.json")),
            Does.Contain("VK_DRIVER_FILES is set to /nope.json, which is not there; unset it"));
        Assert.That(Blame(("VK_ICD_FILENAMES", "/nope.json")), Does.Contain("VK_ICD_FILENAMES is set to /nope.json"));
        Assert.That(Blame(("VK_DRIVER_FILES", present), ("VK_ICD_FILENAMES", "/nope.json")),
            Does.Contain($"VK_DRIVER_FILES is set to {present}, whose driver gives none"));
        Assert.That(Blame(("VK_DRIVER_FILES", "")), Is.Null);
    }

    [Test]
    public void Buffer_BeyondTheDevicesRange_NamesBothFigures()
    {
        long bytes = _device.Limits.MaxStorageBufferRange + 4;
        var error = Assert.Throws<VulkanException>(() => _device.CreateBuffer(bytes));
        Assert.That(error.Message,
            Does.Contain($"{bytes:N0}").And.Contain($"{_device.Limits.MaxStorageBufferRange:N0}"));
    }

    [TestCase(0)]
    [TestCase(-1)]
    public void Buffer_OfNoBytes_IsRefused(long bytes) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => _device.CreateBuffer(bytes));

    [TestCase(13, 0)]
    [TestCase(1, 16)]
    [TestCase(4, -1)]
    public void Access_OutsideTheBuffer_IsRefused(int bytes, long offset)
    {
        using var buffer = _device.CreateBuffer(12);
        Assert.Throws<ArgumentOutOfRangeException>(() => buffer.Read(new byte[bytes], offset));
        Assert.Throws<ArgumentOutOfRangeException>(() => buffer.Write(new byte[bytes], offset));
    }

    [Test]
    public void Dispatch_WithoutABuffer_NamesIt()
    {
        using var program = Kernels.Create(_device, Kernels.Arithmetic, "Add");
        using var buffer = _device.CreateBuffer(4);
        var error = Assert.Throws<VulkanException>(() => _device.Dispatch(
            program, new byte[program.UniformBytes], Kernels.Bind(("Left", buffer), ("Sum", buffer)), 1, 1, 1));
        Assert.That(error.Message, Is.EqualTo("kernel Add: buffer Right is not set"));
    }

    [Test]
    public void Dispatch_WithADisposedBuffer_NamesIt()
    {
        using var program = Kernels.Create(_device, Kernels.Arithmetic, "Step");
        var buffer = _device.CreateBuffer(4);
        buffer.Dispose();
        var error = Assert.Throws<VulkanException>(
            () => _device.Dispatch(program, new byte[program.UniformBytes], Kernels.Bind(("State", buffer)), 1, 1, 1));
        Assert.That(error.Message, Does.Contain("State").And.Contain("disposed"));
    }

    [TestCase(false)]
    [TestCase(true)] // its pipeline is made
    public void Dispatch_OfADisposedKernel_NamesIt(bool hasRun)
    {
        var program = Kernels.Create(_device, Kernels.Arithmetic, "Step");
        using var buffer = _device.CreateBuffer(4);
        void Run() => _device.Dispatch(
            program, new byte[program.UniformBytes], Kernels.Bind(("State", buffer)), 1, 1, 1);
        if (hasRun)
            Run();
        program.Dispose();
        Assert.That(Assert.Throws<ObjectDisposedException>(Run).Message, Does.Contain("Step was disposed"));
    }

    [Test]
    public void Dispatch_OfTooManyGroups_NamesTheLimit()
    {
        using var program = Kernels.Create(_device, Kernels.Arithmetic, "Step");
        using var buffer = _device.CreateBuffer(4);
        var error = Assert.Throws<VulkanException>(() => _device.Dispatch(
            program, new byte[program.UniformBytes],
            Kernels.Bind(("State", buffer)), 1, _device.Limits.MaxGroupsY + 1, 1));
        Assert.That(error.Message, Does.Contain(_device.Limits.MaxGroupsY.ToString()));
    }

    [Test]
    public void Dispatch_WithUniformsOfTheWrongSize_IsRefused()
    {
        using var program = Kernels.Create(_device, Kernels.Arithmetic, "Step");
        using var buffer = _device.CreateBuffer(4);
        Assert.Throws<VulkanException>(
            () => _device.Dispatch(program, new byte[3], Kernels.Bind(("State", buffer)), 1, 1, 1));
    }

    [Test]
    public void Program_OfBytesThatAreNoSpirv_IsRefused()
    {
        byte[] good = ShaderLibrary.Load(Kernels.Arithmetic, "Add");
        foreach (byte[] bad in new[] { [], new byte[64], good[..^5], good[..^4], good[..24] })
            Assert.Throws<VulkanException>(() => _device.CreateProgram(bad), $"{bad.Length} bytes");
    }

    [Test]
    public void Program_WithATexelBuffer_NamesIt()
    {
        byte[] code = ShaderLibrary.Load(Kernels.Buffers, "ReadTexels");
        var error = Assert.Throws<VulkanException>(() => _device.CreateProgram(code));
        Assert.That(error.Message, Does.Contain("ReadTexels: _Texels is").And.Contain("only structured"));
    }

    [Test]
    public void Kernel_ThatTheFileLacks_NamesThoseItHas()
    {
        var error = Assert.Throws<VulkanException>(() => ShaderLibrary.Load(Kernels.Arithmetic, "Subtract"));
        Assert.That(error.Message, Does.Contain("Subtract").And.Contain("Add, Step, Scale"));
        Assert.That(Assert.Throws<VulkanException>(() => ShaderLibrary.Load("Assets/None.compute", "Main")).Message,
            Does.Contain("Assets/None.compute"));
    }

    [Test]
    public void Kernels_OfChangedSources_AreStale()
    {
        string root = Directory.CreateTempSubdirectory("glint-stale").FullName;
        try
        {
            string include = Path.Combine(root, "tools/Tests/Host/Shaders/Bounds.hlsl");
            string shader = Path.Combine(root, Kernels.Arithmetic);
            Directory.CreateDirectory(Path.GetDirectoryName(shader));
            File.Copy(Path.Combine(Sources.Root, Kernels.Arithmetic), shader);
            File.Copy(Path.Combine(Sources.Root, "tools/Tests/Host/Shaders/Bounds.hlsl"), include);
            Assert.DoesNotThrow(() => ShaderLibrary.RequireSources(root, Kernels.Arithmetic));

            File.AppendAllText(include, "// changed\n");
            var error = Assert.Throws<VulkanException>(() => ShaderLibrary.RequireSources(root, Kernels.Arithmetic));
            Assert.That(error.Message, Does.Contain("Bounds.hlsl changed").And.Contain("tools/glint"));

            File.Delete(include);
            Assert.That(
                Assert.Throws<VulkanException>(() => ShaderLibrary.RequireSources(root, Kernels.Arithmetic)).Message,
                Does.Contain("Bounds.hlsl"));
        }
        finally
        {
            Directory.Delete(root, true);
        }
    }
}
