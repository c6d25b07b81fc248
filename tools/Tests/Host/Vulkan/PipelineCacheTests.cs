using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Vulkan;
using NUnit.Framework;

namespace Glint.Host.Tests.Vulkan;

/// <summary>
/// Files of compiled kernels. Not every driver hands out what it compiled, so the data of most tests are their own.
/// </summary>
public sealed class PipelineCacheTests
{
    const uint Vendor = 0x10de, Device = 0x2330, Driver = 0x8c0401;

    static readonly byte[] Uuid = [.. Enumerable.Range(1, 16).Select(i => (byte)(17 * i))];
    static readonly byte[] Header = PipelineCacheFile.Header(Vendor, Device, Uuid);
    static readonly byte[] Spirv = [3, 2, 35, 7];
    static readonly byte[] Data = [.. Header, 1, 2, 3, 4, 5];

    string _root, _folder;

    [SetUp]
    public void MakeFolder()
    {
        _root = Directory.CreateTempSubdirectory("glint-pipelines-").FullName;
        _folder = Path.Combine(_root, "cache", "glint");
    }

    [TearDown] public void RemoveFolder() => Directory.Delete(_root, true);

    // The layout of the specification: length, version, vendor, device, little-endian, then the UUID.
    [Test]
    public void Header_OfADevice_IsThatOfVulkan() => Assert.That(Header, Is.EqualTo(
        new byte[] { 32, 0, 0, 0, 1, 0, 0, 0, 0xde, 0x10, 0, 0, 0x30, 0x23, 0, 0 }.Concat(Uuid)));

    [Test]
    public void Load_AfterASave_GivesItsData()
    {
        Assert.That(Cache().Load(), Is.Empty, "nothing saved");
        Cache().Save(Data);
        Assert.That(Cache().Load(), Is.EqualTo(Data));
        Cache().Save([.. Data, 6]);
        Assert.That(Cache().Load(), Is.EqualTo(Data.Append((byte)6)), "replaced");
        Assert.That(Directory.GetFiles(_folder), Is.EqualTo(new[] { Cache().FilePath }), "and nothing else");
    }

    [Test]
    public void Save_OfAHeaderOnly_WritesNothing()
    {
        Cache().Save(Header);
        Cache().Save([]);
        Assert.That(Directory.Exists(_folder), Is.False);
    }

    [Test]
    public void Save_OfTheDataLoaded_LeavesTheCache()
    {
        Cache().Save(Data);
        var longAgo = new DateTime(2001, 2, 3, 4, 5, 6, DateTimeKind.Utc);
        File.SetLastWriteTimeUtc(Cache().FilePath, longAgo);
        var file = Cache();
        file.Save(file.Load());
        Assert.That(File.GetLastWriteTimeUtc(file.FilePath), Is.EqualTo(longAgo));
    }

    [Test]
    public void Load_WithAnyByteChanged_GivesNothingAndASaveRebuildsIt()
    {
        Cache().Save(Data);
        var bytes = File.ReadAllBytes(Cache().FilePath);
        for (int i = 0; i < bytes.Length; i++)
        {
            bytes[i] ^= 0x40;
            File.WriteAllBytes(Cache().FilePath, bytes);
            Assert.That(Cache().Load(), Is.Empty, $"byte {i}");
            bytes[i] ^= 0x40;
        }
        var file = Cache();
        file.Load();
        file.Save(Data);
        Assert.That(Cache().Load(), Is.EqualTo(Data));
    }

    [Test]
    public void Load_OfATruncatedOrLongerFile_GivesNothing()
    {
        Cache().Save(Data);
        var bytes = File.ReadAllBytes(Cache().FilePath);
        for (int length = 0; length < bytes.Length; length++)
        {
            File.WriteAllBytes(Cache().FilePath, bytes[..length]);
            Assert.That(Cache().Load(), Is.Empty, $"{length} bytes");
        }
        File.WriteAllBytes(Cache().FilePath, [.. bytes, 0]);
        Assert.That(Cache().Load(), Is.Empty, "a byte more");
    }

    static IEnumerable<TestCaseData> Others()
    {
        var uuid = Uuid.ToArray();
        uuid[15]++;
        yield return new TestCaseData(PipelineCacheFile.Header(Vendor, Device, uuid), Driver, Spirv).SetArgDisplayNames(
            "UUID");
        yield return new TestCaseData(Header, Driver + 1, Spirv).SetArgDisplayNames("driver");
        yield return new TestCaseData(Header, Driver, new byte[] { 3, 2, 35, 8 }).SetArgDisplayNames("kernel");
    }

    [TestCaseSource(nameof(Others))]
    public void Load_OfAnotherDeviceDriverOrKernel_GivesNothingEvenFromARenamedFile(byte[] header, uint driver,
        byte[] spirv)
    {
        Cache().Save(Data);
        var other = new PipelineCacheFile(_folder, header, driver, spirv);
        Assert.That(other.FilePath, Is.Not.EqualTo(Cache().FilePath));
        Assert.That(other.Load(), Is.Empty);
        File.Move(Cache().FilePath, other.FilePath);
        Assert.That(other.Load(), Is.Empty);
    }

    // The driver's header has to be that of the device, whatever the name says.
    [TestCase(0, TestName = "{m}(length)")]
    [TestCase(4, TestName = "{m}(version)")]
    [TestCase(8, TestName = "{m}(vendor)")]
    [TestCase(12, TestName = "{m}(device)")]
    [TestCase(31, TestName = "{m}(UUID)")]
    public void Load_OfDataWithAForeignHeader_GivesNothing(int changed)
    {
        var data = Data.ToArray();
        data[changed]++;
        Cache().Save(data);
        Assert.That(Cache().FilePath, Does.Exist);
        Assert.That(Cache().Load(), Is.Empty);
    }

    [Test]
    public void Save_InAFolderThatCannotBeMade_IsNoError()
    {
        File.WriteAllText(Path.Combine(_root, "cache"), "a file in the folder's place");
        Cache().Save(Data);
        Assert.That(Cache().Load(), Is.Empty);
    }

    [Test]
    public void Save_ThatCannotReplaceTheFile_LeavesNoTemporaryCache()
    {
        Directory.CreateDirectory(Cache().FilePath);
        Cache().Save(Data);
        Assert.That(Cache().Load(), Is.Empty);
        Assert.That(Directory.GetFileSystemEntries(_folder), Is.EqualTo(new[] { Cache().FilePath }));
    }

    [Test]
    public void Save_WithoutAFolder_IsNoError()
    {
        var file = new PipelineCacheFile(null, Header, Driver, Spirv);
        file.Save(Data);
        Assert.That(file.Load(), Is.Empty);
    }

    [TestCase("/cache", "/home/a", "/cache/glint")]
    [TestCase(null, "/home/a", "/home/a/.cache/glint")]
    [TestCase("", "/home/a", "/home/a/.cache/glint")]
    [TestCase("relative", "/home/a", "/home/a/.cache/glint")]
    [TestCase(null, null, null)]
    [Platform("Linux")]
    public void UserFolder_OfAnEnvironment_FollowsTheXdgSpecification(string cache, string home, string expected) =>
        Assert.That(PipelineCacheFile.UserFolder(name => name == "XDG_CACHE_HOME" ? cache : home),
            Is.EqualTo(expected));

    // A driver that hands out only the header leaves the file as it is; another replaces it.
    [Test]
    public void Dispatch_WithADamagedFile_RunsTheKernel()
    {
        using var device = OpenWithFolder();
        var file = new PipelineCacheFile(_folder, device.Physical.PipelineCacheHeader, device.Physical.DriverVersion,
            ShaderLibrary.Load(Kernels.Indirect, "Mark"));
        Directory.CreateDirectory(_folder);
        File.WriteAllText(file.FilePath, "damaged");

        Assert.That(Mark(device), Is.EqualTo(new[] { 12, 12, 12, 0 }));
        Assert.That(File.ReadAllText(file.FilePath) == "damaged"
            || file.Load().Length > PipelineCacheFile.HeaderBytes, "left alone or rebuilt");
    }

    [Test]
    public void Compiling_IsRaisedForAKernelThatNoRunHasCompiled()
    {
        var devices = new List<string>();
        void Add(DeviceInfo device) => devices.Add(device.Name);
        ComputeProgram.Compiling += Add;
        try
        {
            for (int run = 0; run < 2; run++)
            {
                using var device = OpenWithFolder();
                Mark(device);
                Assert.That(devices, Is.EqualTo(new[] { device.Info.Name }), $"run {run}");
            }
        }
        finally
        {
            ComputeProgram.Compiling -= Add;
        }
    }

    [Test]
    public void Dispatch_WithoutAWritableFolder_RunsTheKernel()
    {
        using var device = OpenWithFolder();
        File.WriteAllText(Path.Combine(_root, "cache"), "a file in the folder's place");
        Assert.That(Mark(device), Is.EqualTo(new[] { 12, 12, 12, 0 }));
    }

    [Test]
    public void Program_BegunWithItsFile_RunsAndWithoutIsNotMade()
    {
        using var device = OpenWithFolder();
        static byte[] Load() => ShaderLibrary.Load(Kernels.Indirect, "Mark");
        Assert.That(device.BeginStoredProgram(Load).Result, Is.Null);

        Directory.CreateDirectory(_folder);
        File.WriteAllText(new PipelineCacheFile(_folder, device.Physical.PipelineCacheHeader,
            device.Physical.DriverVersion, Load()).FilePath, "damaged");
        using var program = device.BeginStoredProgram(Load).Result;
        Assert.That(Mark(device, program), Is.EqualTo(new[] { 12, 12, 12, 0 }));
        // Closing the device waits for it.
        _ = device.BeginStoredProgram(Load);
    }

    VulkanDevice OpenWithFolder()
    {
        var device = VulkanDevice.Open(Engine.DeviceSelector);
        device.PipelineCacheFolder = _folder;
        return device;
    }

    static int[] Mark(VulkanDevice device)
    {
        using var program = Kernels.Create(device, Kernels.Indirect, "Mark");
        return Mark(device, program);
    }

    static int[] Mark(VulkanDevice device, ComputeProgram program)
    {
        using var marks = Kernels.Buffer(device, new int[4]);
        device.Dispatch(program, Kernels.Pack(program), Kernels.Bind(("_Marks", marks)), 3, 2, 1);
        return Kernels.Read<int>(marks);
    }

    PipelineCacheFile Cache() => new(_folder, Header, Driver, Spirv);
}
