using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Host.Tests.Vulkan;

public sealed class ReadbackTests
{
    ComputeBuffer _buffer;

    [SetUp]
    public void MakeBuffer()
    {
        _buffer = new ComputeBuffer(4, 4);
        _buffer.SetData(new[] { 1, 2, 3, 4 });
    }

    [TearDown] public void ReleaseBuffer() => _buffer.Release();

    [Test]
    public void Request_IsDoneInALaterFrameAndLastsOne()
    {
        var request = AsyncGPUReadback.Request(_buffer);
        Assert.That(request.done, Is.False);
        Assert.Throws<InvalidOperationException>(() => request.GetData<int>());

        AsyncGPUReadback.Pump();
        Assert.That((request.done, request.hasError), Is.EqualTo((true, false)));
        Assert.That(request.GetData<int>().ToArray(), Is.EqualTo(new[] { 1, 2, 3, 4 }));

        AsyncGPUReadback.Pump();
        Assert.That(request.hasError, Is.True);
        Assert.Throws<InvalidOperationException>(() => request.GetData<int>());
    }

    [Test]
    public void Request_OfAPart_CallsBackOnceWithIt()
    {
        var seen = new List<int>();
        AsyncGPUReadback.Request(_buffer, 8, 4, request => seen.AddRange(request.GetData<int>()));
        AsyncGPUReadback.Pump();
        AsyncGPUReadback.Pump();
        Assert.That(seen, Is.EqualTo(new[] { 2, 3 }));
    }

    [Test]
    public void Request_HasTheBytesOfItsMoment()
    {
        var request = AsyncGPUReadback.Request(_buffer);
        _buffer.SetData(new int[4]);
        request.WaitForCompletion();
        Assert.That(request.GetData<int>()[3], Is.EqualTo(4));
    }

    [Test]
    public void RequestIntoNativeArray_FillsIt()
    {
        var output = new NativeArray<int>(4, Allocator.Persistent);
        AsyncGPUReadback.RequestIntoNativeArray(ref output, _buffer);
        Assert.That(output.ToArray(), Is.All.Zero);
        AsyncGPUReadback.WaitAllRequests();
        Assert.That(output.ToArray(), Is.EqualTo(new[] { 1, 2, 3, 4 }));
        output.Dispose();
    }

    [Test]
    public void RequestIntoNativeArray_DisposedMeanwhile_IsAnError()
    {
        var output = new NativeArray<int>(4, Allocator.Persistent);
        var request = AsyncGPUReadback.RequestIntoNativeArray(ref output, _buffer);
        output.Dispose();
        using var log = new LogCapture();
        request.WaitForCompletion();
        Assert.That((request.done, request.hasError), Is.EqualTo((true, true)));
        Assert.That(log.Messages.Select(message => message.Type), Is.EqualTo(new[] { LogType.Error }));
    }

    [Test]
    public void Request_OutsideTheBuffer_IsRefused()
    {
        Assert.Throws<ArgumentException>(() => AsyncGPUReadback.Request(_buffer, 8, 12));
        Assert.Throws<ArgumentException>(() => AsyncGPUReadback.Request(_buffer, 4, -4));
        Assert.Throws<ArgumentNullException>(() => AsyncGPUReadback.Request((ComputeBuffer)null));
        var small = new NativeArray<int>(3, Allocator.Temp);
        Assert.Throws<ArgumentException>(() => AsyncGPUReadback.RequestIntoNativeArray(ref small, _buffer));
        small.Dispose();
    }

    [Test]
    public void Frame_OfTheEngine_CompletesRequests()
    {
        var request = AsyncGPUReadback.Request(_buffer);
        Engine.Step();
        Assert.That(request.done, Is.True);
    }
}
