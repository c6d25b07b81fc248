using Glint.Vulkan;
using NUnit.Framework;

namespace Glint.Host.Tests.Vulkan;

public sealed class GraphicsDeviceTests
{
    string _selector;

    [SetUp]
    public void SetUp()
    {
        GraphicsDevice.Close();
        _selector = Engine.DeviceSelector;
    }

    [TearDown]
    public void TearDown()
    {
        GraphicsDevice.Close();
        Engine.DeviceSelector = _selector;
    }

    [Test]
    public void BeginOpening_GivesTheDeviceOfTheFirstUse()
    {
        GraphicsDevice.BeginOpening();
        var device = GraphicsDevice.Current;
        Assert.That(device.Info, Is.EqualTo(VulkanDevice.List()[device.Info.Index]));
        Assert.That(GraphicsDevice.Current, Is.SameAs(device));
    }

    [Test]
    public void BeginOpening_OfNoDevice_FailsAtTheFirstUseAndOnlyThere()
    {
        Engine.DeviceSelector = "no such device";
        GraphicsDevice.BeginOpening();
        Assert.That(Assert.Throws<VulkanException>(() => _ = GraphicsDevice.Current).Message,
            Does.Contain("no such device"));
        Engine.DeviceSelector = _selector;
        Assert.That(GraphicsDevice.Current, Is.Not.Null);
    }

    [Test]
    public void BeginOpening_OfAnotherDeviceThanIsUsed_IsClosed()
    {
        GraphicsDevice.BeginOpening();
        Engine.DeviceSelector = "0";
        Assert.That(GraphicsDevice.Current.Info.Index, Is.EqualTo(0));
    }

    [TestCase(null)]
    [TestCase("no such device")]
    public void Close_OfADeviceThatNothingUsed_IsSilent(string selector)
    {
        Engine.DeviceSelector = selector;
        GraphicsDevice.BeginOpening();
        Assert.DoesNotThrow(GraphicsDevice.Close);
    }
}
