using System;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;

namespace Glint.Host.Tests.Vulkan;

public sealed class NativeArrayTests
{
    [Test]
    public void New_IsZeroAndHoldsWhatIsSet()
    {
        using var array = new NativeArray<double>(3, Allocator.Persistent);
        Assert.That(array.ToArray(), Is.EqualTo(new double[3]));
        Set(array, 1, 2.5);
        Assert.That(array.Sum(), Is.EqualTo(2.5));
    }

    [Test]
    public void Index_OutsideTheArray_IsRefused()
    {
        using var array = new NativeArray<int>(2, Allocator.Temp);
        Assert.Throws<IndexOutOfRangeException>(() => _ = array[2]);
        Assert.Throws<IndexOutOfRangeException>(() => _ = array[-1]);
        Assert.Throws<IndexOutOfRangeException>(() => _ = default(NativeArray<int>)[0]);
    }

    [Test]
    public void Dispose_ThroughOneCopy_EndsAll()
    {
        var array = new NativeArray<int>(2, Allocator.Temp);
        var copy = array;
        var part = array.GetSubArray(1, 1);
        Assert.Throws<InvalidOperationException>(() => part.Dispose());
        array.Dispose();
        array.Dispose();
        Assert.That(array.IsCreated, Is.False);
        Assert.Throws<ObjectDisposedException>(() => _ = copy[0]);
        Assert.Throws<ObjectDisposedException>(() => _ = part[0]);
        Assert.Throws<ObjectDisposedException>(() => copy.Dispose());
    }

    [Test]
    public void Copies_NeedRoom()
    {
        using var array = new NativeArray<int>(new[] { 1, 2, 3 }, Allocator.Temp);
        using var same = new NativeArray<int>(array, Allocator.Temp);
        Assert.That(same.ToArray(), Is.EqualTo(new[] { 1, 2, 3 }));
        Assert.Throws<ArgumentException>(() => array.CopyTo(new int[2]));
        Assert.Throws<ArgumentException>(() => array.CopyFrom(new int[4]));
        var target = new int[5];
        NativeArray<int>.Copy(array, 1, target, 3, 2);
        Assert.That(target, Is.EqualTo(new[] { 0, 0, 0, 2, 3 }));
        Assert.Throws<ArgumentException>(() => NativeArray<int>.Copy(array, 1, target, 4, 2));
        Assert.Throws<ArgumentOutOfRangeException>(() => NativeArray<int>.Copy(array, -1, target, 0, 1));
    }

    [Test]
    public void Views_ShareTheMemory()
    {
        using var array = new NativeArray<float>(new[] { 1f, 2f, 3f, 4f }, Allocator.Temp);
        var part = array.GetSubArray(2, 2);
        Set(part, 0, -1f);
        Assert.That(array[2], Is.EqualTo(-1f));
        Assert.That(array.Reinterpret<int>()[0], Is.EqualTo(BitConverter.SingleToInt32Bits(1)));
        Assert.That(array.Reinterpret<long>(4).Length, Is.EqualTo(2));
        Assert.Throws<InvalidOperationException>(() => array.Reinterpret<long>());
        Assert.Throws<ArgumentOutOfRangeException>(() => array.GetSubArray(3, 2));
        Assert.That(array.AsReadOnly().ToArray(), Is.EqualTo(array.ToArray()));
    }

    [Test]
    public void Constructor_OfBadArguments_IsRefused()
    {
        Assert.Throws<ArgumentException>(() => new NativeArray<int>(1, Allocator.None));
        Assert.Throws<ArgumentOutOfRangeException>(() => new NativeArray<int>(-1, Allocator.Temp));
        Assert.Throws<ArgumentNullException>(() => new NativeArray<int>((int[])null, Allocator.Temp));
        Assert.Throws<InvalidOperationException>(() => new NativeArray<(string, int)>(1, Allocator.Temp));
    }

    static void Set<T>(NativeArray<T> array, int index, T value) where T : struct => array[index] = value;
}
