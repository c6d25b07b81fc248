using System.Diagnostics;
using Glint.Vulkan;
using NUnit.Framework;

namespace Glint.Host.Tests.Vulkan;

public sealed class GpuClockTests
{
    const int Count = 1 << 20;

    VulkanDevice _device;
    ComputeProgram _program;
    GpuBuffer _state;

    [SetUp]
    public void OpenDevice()
    {
        _device = VulkanDevice.Open();
        _program = Kernels.Create(_device, Kernels.Arithmetic, "Step");
        _state = _device.CreateBuffer(4 * Count);
    }

    [TearDown] public void CloseDevice() => _device.Dispose();

    [Test]
    public void Clock_Off_StandsStill()
    {
        Dispatch(3);
        Assert.That(_device.Clock.IsOn, Is.False);
        Assert.That(_device.Clock.Read(), Is.Zero);
    }

    [TestCase(1)]
    [TestCase(40)] // more than a batch
    public void Clock_On_CountsNoMoreThanTheWallDoes(int dispatches)
    {
        Dispatch(1); // compiles
        _device.Wait();
        _device.Clock.IsOn = true;
        _device.Clock.Reset();
        var watch = Stopwatch.StartNew();
        Dispatch(dispatches);
        double device = _device.Clock.Read();
        double wall = watch.Elapsed.TotalMilliseconds;
        Assert.That(device, Is.GreaterThan(0).And.LessThanOrEqualTo(wall));
        Assert.That(_device.Clock.Read(), Is.EqualTo(device), "read again");
    }

    [Test]
    public void Clock_DuringCopies_StandsStill()
    {
        _device.Clock.IsOn = true;
        _state.Write(new byte[4 * Count]);
        _state.Read(new byte[4 * Count]);
        Assert.That(_device.Clock.Read(), Is.Zero);
    }

    [Test]
    public void Clock_SwitchedOnAndOff_CountsWhatIsBetween()
    {
        Dispatch(5);
        _device.Clock.IsOn = true;
        Dispatch(1);
        _device.Clock.IsOn = false;
        double one = _device.Clock.Read();
        Dispatch(5);
        Assert.That(_device.Clock.Read(), Is.EqualTo(one).And.GreaterThan(0));
        _device.Clock.Reset();
        Assert.That(_device.Clock.Read(), Is.Zero);
    }

    void Dispatch(int times)
    {
        for (int i = 0; i < times; i++)
            _device.Dispatch(_program, Kernels.Pack(_program, ("Count", (uint)Count), ("Increment", 1u)),
                Kernels.Bind(("State", _state)), 65535 / 4, 1, 1);
    }
}
