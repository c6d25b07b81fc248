using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.CompilerServices;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;

namespace Glint.Host.Tests.Vulkan;

public sealed class ComputeBufferTests
{
    [TestCase(0, 4)]
    [TestCase(-1, 4)]
    [TestCase(1, 0)]
    [TestCase(1, 6)]
    [TestCase(1, 2048)]
    public void Constructor_OfSuchCountOrStride_IsRefused(int count, int stride)
    {
        Assert.Throws<ArgumentException>(() => new ComputeBuffer(count, stride));
        Assert.Throws<ArgumentException>(() => new GraphicsBuffer(GraphicsBuffer.Target.Structured, count, stride));
    }

    [Test]
    public void Constructor_BeyondTheDevice_NamesTheLimit()
    {
        long elements = SystemInfo.maxGraphicsBufferSize / 2044 + 1;
        var error = Assert.Throws<ArgumentException>(() => new ComputeBuffer((int)elements, 2044));
        Assert.That(error.Message, Does.Contain($"{SystemInfo.maxGraphicsBufferSize:N0}"));
    }

    [Test]
    public void Data_OfAnArrayListOrNativeArray_ComesBack()
    {
        using var buffer = new ComputeBuffer(3, 12);
        var vectors = new[] { new Vector3(1, 2, 3), new Vector3(4, 5, 6), new Vector3(7, 8, 9) };
        using var native = new NativeArray<Vector3>(vectors, Allocator.Temp);
        foreach (Action set in new Action[]
        {
            () => buffer.SetData(vectors), () => buffer.SetData(new List<Vector3>(vectors)),
            () => buffer.SetData(native)
        })
        {
            buffer.SetData(new Vector3[3]);
            set();
            var back = new Vector3[3];
            buffer.GetData(back);
            Assert.That(back, Is.EqualTo(vectors));
        }
    }

    [Test]
    public void Data_OfARange_IsCountedInElementsOfTheArray()
    {
        using var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 2, 16);
        buffer.SetData(new[] { 0, 1, 2, 3, 4 }, 2, 5, 3);
        buffer.SetData(new List<int> { 8, 9 }, 1, 0, 1);
        var back = new int[4];
        buffer.GetData(back, 1, 5, 3);
        Assert.That(back, Is.EqualTo(new[] { 0, 2, 3, 4 }));
        buffer.GetData(back, 0, 0, 1);
        Assert.That(back[0], Is.EqualTo(9));
    }

    [Test]
    public void Data_OfTheLargestBuffer_ComesBackWholeAndInParts()
    {
        int rows = (int)(Math.Min(SystemInfo.maxGraphicsBufferSize, 160 << 20) / 16);
        using var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, rows, 16);
        var data = new Vector4[rows];
        for (int i = 0; i < rows; i++)
            data[i] = new Vector4(i, -i, 0.5f, 1);
        buffer.SetData(data);
        buffer.SetData(new[] { new Vector4(7, 7, 7, 7) }, 0, rows - 2, 1);

        var back = new Vector4[rows];
        buffer.GetData(back);
        data[rows - 2] = new Vector4(7, 7, 7, 7);
        Assert.That(back.AsSpan().SequenceEqual(data));
        buffer.GetData(back, 0, rows - 3, 3);
        Assert.That(back[..3], Is.EqualTo(data[^3..]));
    }

    [Test]
    public void Data_OutOfRange_IsRefused()
    {
        using var buffer = new ComputeBuffer(4, 4);
        Assert.Throws<ArgumentException>(() => buffer.SetData(new float[5]));
        Assert.Throws<ArgumentException>(() => buffer.SetData(new float[4], 0, 1, 4));
        Assert.Throws<ArgumentOutOfRangeException>(() => buffer.SetData(new float[4], 2, 0, 3));
        Assert.Throws<ArgumentOutOfRangeException>(() => buffer.SetData(new float[4], -1, 0, 1));
        Assert.Throws<ArgumentException>(() => buffer.GetData(new float[5]));
        Assert.Throws<ArgumentNullException>(() => buffer.SetData((Array)null));
        Assert.Throws<ArgumentNullException>(() => buffer.SetData((List<float>)null));
        Assert.Throws<ArgumentException>(() => buffer.SetData(new[] { "text" }));
    }

    [Test]
    public void Release_Twice_LeavesAnInvalidBuffer()
    {
        var buffer = new ComputeBuffer(4, 4);
        Assert.That(buffer.IsValid(), Is.True);
        buffer.Release();
        buffer.Dispose();
        Assert.That(buffer.IsValid(), Is.False);
        Assert.Throws<NullReferenceException>(() => buffer.SetData(new float[1]));
    }

    [Test]
    public void Buffer_LeftToTheGarbageCollector_IsWarnedOf()
    {
        using var log = new LogCapture();
        Forget();
        for (int i = 0; i < 20 && log.Messages.Count == 0; i++)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
            GraphicsDevice.CollectLeaks();
        }
        Assert.That(log.Messages.Select(message => (message.Type, message.Text)), Is.EqualTo(new[]
        {
            (LogType.Warning, "GarbageCollector disposing of ComputeBuffer. "
                + "Please use ComputeBuffer.Release() or .Dispose() to manually release the buffer."),
        }));
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    static void Forget() => _ = new ComputeBuffer(4, 4);
}
