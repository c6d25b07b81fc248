using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Vulkan;
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

        _buffer.GetData(new int[4]); // the device is done
        Assert.That(request.done, Is.False);
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
        for (int frame = 0; frame < 3; frame++)
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
    public void Requests_BetweenDispatches_HaveTheBytesOfTheirMoment()
    {
        using var steps = new Steps(1000);
        var requests = new List<AsyncGPUReadbackRequest>();
        var expected = new List<uint[]>();
        for (int i = 0; i < 40; i++) // more than the batches in flight
        {
            steps.Run(3);
            requests.Add(AsyncGPUReadback.Request(steps.State));
            expected.Add(steps.Expected.ToArray());
            if (i % 7 == 3)
                steps.Clear();
        }
        AsyncGPUReadback.WaitAllRequests();
        for (int i = 0; i < requests.Count; i++)
            Assert.That(requests[i].GetData<uint>().ToArray(), Is.EqualTo(expected[i]), $"request {i}");
    }

    [Test]
    public void PosesInFlight_HaveTheBytesOfPosesOneAtATime()
    {
        var oneAtATime = Poses(1);
        Assert.That(oneAtATime.Distinct().Count(), Is.EqualTo(oneAtATime.Count), "the poses differ");
        Assert.That(Poses(2), Is.EqualTo(oneAtATime));
        Assert.That(Poses(5), Is.EqualTo(oneAtATime));
    }

    [Test]
    public void Request_InFlight_IsDoneAfterTwoFramesAtTheLatest()
    {
        using var steps = new Steps(1 << 18);
        steps.Run(30);
        int calls = 0;
        var request = AsyncGPUReadback.Request(steps.State, _ => calls++);
        AsyncGPUReadback.Pump();
        AsyncGPUReadback.Pump();
        Assert.That((request.done, request.hasError, calls), Is.EqualTo((true, false, 1)));
        Assert.That(request.GetData<uint>()[5], Is.EqualTo(steps.Expected[5]));
    }

    [Test]
    public void Update_DeliversWhatHasCome()
    {
        var request = AsyncGPUReadback.Request(_buffer);
        _buffer.GetData(new int[4]); // the device is done
        request.Update();
        Assert.That((request.done, request.GetData<int>()[2]), Is.EqualTo((true, 3)));
    }

    [Test]
    public void Request_OfABufferReleasedMeanwhile_IsAnError()
    {
        var buffer = new ComputeBuffer(4, 4);
        var errors = new List<bool>();
        var request = AsyncGPUReadback.Request(buffer, done => errors.Add(done.hasError));
        buffer.Release();
        Assert.That(request.done, Is.False);
        AsyncGPUReadback.Pump();
        Assert.That((request.done, request.hasError), Is.EqualTo((true, true)));
        Assert.That(errors, Is.EqualTo(new[] { true }));
        Assert.Throws<InvalidOperationException>(() => request.GetData<int>());
    }

    [Test]
    public void Request_OnADeviceClosedMeanwhile_IsAnError()
    {
        using var steps = new Steps(1 << 18);
        steps.Run(30);
        var request = AsyncGPUReadback.Request(steps.State);
        GraphicsDevice.Close();
        request.WaitForCompletion();
        Assert.That((request.done, request.hasError), Is.EqualTo((true, true)));
    }

    [Test]
    public void Request_OnALostDevice_IsAnErrorWithItsReason()
    {
        GraphicsDevice.Close();
        using var steps = new Steps(16);
        steps.Run(1);
        GraphicsDevice.Current.Recorder.LastBatch = GraphicsDevice.Current.Recorder.Batch - 1;
        var error = Assert.Throws<VulkanException>(() => AsyncGPUReadback.Request(steps.State));
        Assert.That(error.Message, Does.Contain("run 1 dispatches").And.Contain("the device was lost"));
        GraphicsDevice.Close();
    }

    [Test]
    public void Device_WithoutReadback_RefusesRequests()
    {
        GraphicsDevice.HasAsyncReadback = false;
        try
        {
            Assert.That(SystemInfo.supportsAsyncGPUReadback, Is.False);
            Assert.Throws<NotSupportedException>(() => AsyncGPUReadback.Request(_buffer));
        }
        finally
        {
            GraphicsDevice.HasAsyncReadback = true;
        }
        Assert.That(SystemInfo.supportsAsyncGPUReadback, Is.True);
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
        Engine.Step();
        Assert.That(request.done, Is.True);
    }

    /// <summary>Results of 12 poses, each of 12 dispatches, so many of them in flight at a time.</summary>
    static List<string> Poses(int inFlight)
    {
        var results = new List<string>();
        var requests = new Queue<AsyncGPUReadbackRequest>();
        var buffers = Enumerable.Range(0, inFlight).Select(_ => new Steps(5000)).ToArray();
        for (int pose = 0; pose < 12 + inFlight; pose++)
        {
            if (pose >= inFlight)
            {
                var request = requests.Dequeue();
                request.WaitForCompletion();
                results.Add(string.Join(' ', request.GetData<uint>().Take(50)));
            }
            if (pose < 12)
            {
                var steps = buffers[pose % inFlight];
                steps.Clear();
                steps.Run(12, pose);
                requests.Enqueue(AsyncGPUReadback.Request(steps.State));
            }
        }
        foreach (var steps in buffers)
            steps.Dispose();
        return results;
    }

    /// <summary>A buffer on which kernels step, and what the host computes for it.</summary>
    sealed class Steps : IDisposable
    {
        readonly ComputeShader _shader = new("Arithmetic", Sources.Root, Kernels.Arithmetic,
            ShaderLibrary.Kernels(Kernels.Arithmetic));
        readonly int _step;
        uint _increment;

        internal Steps(int count)
        {
            State = new GraphicsBuffer(GraphicsBuffer.Target.Structured, count, 4);
            Expected = new uint[count];
            _step = _shader.FindKernel("Step");
            _shader.SetBuffer(_step, "State", State);
            _shader.SetInt("Count", count);
        }

        internal GraphicsBuffer State { get; }

        internal uint[] Expected { get; }

        internal void Run(int times, int seed = 0)
        {
            for (int time = 0; time < times; time++)
            {
                _increment = _increment * 31 + (uint)seed + 1;
                _shader.SetInt("Increment", (int)_increment);
                _shader.Dispatch(_step, (State.count + 31) / 32, 1, 1);
                for (uint i = 0; i < Expected.Length; i++)
                    Expected[i] = Expected[i] * 1664525u + _increment + i;
            }
        }

        internal void Clear()
        {
            Array.Clear(Expected);
            State.SetData(Expected);
            _increment = 0;
        }

        public void Dispose()
        {
            State.Release();
            UnityEngine.Object.DestroyImmediate(_shader);
        }
    }
}
