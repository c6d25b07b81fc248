using System;
using System.Linq;
using System.Runtime.InteropServices;
using Glint.Vulkan;
using NUnit.Framework;

namespace Glint.Host.Tests.Vulkan;

/// <summary>
/// Every test runs twice: with memory mapped for the host (as on a CPU device), and with staging buffers (as on a
/// discrete GPU).
/// </summary>
[TestFixture(true)]
[TestFixture(false)]
public sealed class DispatchTests
{
    readonly bool _mapBuffers;
    VulkanDevice _device;

    public DispatchTests(bool mapBuffers) => _mapBuffers = mapBuffers;

    [SetUp] public void OpenDevice() => _device = VulkanDevice.Open(null, _mapBuffers);

    [TearDown] public void CloseDevice() => _device.Dispose();

    [TestCase(1)]
    [TestCase(64)]
    [TestCase(1_000_003)] // prime: the last group is not full
    public void VectorAdd_OfAnyLength_IsTheSum(int count)
    {
        float[] left = Enumerable.Range(0, count).Select(i => 0.5f * i).ToArray();
        float[] right = Enumerable.Range(0, count).Select(i => 7f - i).ToArray();
        using var program = Kernels.Create(_device, Kernels.Arithmetic, "Add");
        using var a = Kernels.Buffer(_device, left);
        using var b = Kernels.Buffer(_device, right);
        using var sum = _device.CreateBuffer(4L * count);

        _device.Dispatch(program, Kernels.Pack(program, ("Count", (uint)count)),
            Kernels.Bind(("Left", a), ("Right", b), ("Sum", sum)), (uint)(count + 63) / 64, 1, 1);

        Assert.That(Kernels.Read<float>(sum).SequenceEqual(left.Zip(right, (x, y) => x + y)), Is.True);
    }

    [Test]
    public void ProgramsOfOneKernel_ShareAPipelineThatOutlivesThem()
    {
        using var marks = Kernels.Buffer(_device, new int[4]);
        for (int i = 1; i <= 3; i++)
        {
            using var program = Kernels.Create(_device, Kernels.Indirect, "Mark");
            _device.Dispatch(program, Kernels.Pack(program), Kernels.Bind(("_Marks", marks)), 3, 2, 1);
            Assert.That(Kernels.Read<int>(marks), Is.EqualTo(new[] { 12 * i, 12 * i, 12 * i, 0 }));
            Assert.That(_device.Pipelines, Has.Count.EqualTo(1));
        }
    }

    [Test]
    public void NewBuffer_ReadAtOnce_IsZero()
    {
        for (int i = 0; i < 4; i++) // memory that was in use before is reused
        {
            using var buffer = _device.CreateBuffer(3_000_001);
            var data = new byte[buffer.Bytes];
            buffer.Read(data);
            Assert.That(data.All(value => value == 0), Is.True, $"buffer {i}");
            Array.Fill(data, (byte)0xee);
            buffer.Write(data);
        }
    }

    [Test]
    public void ManyDispatches_WithUniformsOfTheirOwn_RunInOrder()
    {
        const int Count = 100, Steps = 1000;
        using var program = Kernels.Create(_device, Kernels.Arithmetic, "Step");
        using var state = _device.CreateBuffer(4 * Count);
        for (uint step = 0; step < Steps; step++)
            _device.Dispatch(program, Kernels.Pack(program, ("Count", (uint)Count), ("Increment", step)),
                Kernels.Bind(("State", state)), 4, 1, 1);

        var expected = new uint[Count];
        for (uint step = 0; step < Steps; step++)
            for (uint i = 0; i < Count; i++)
                expected[i] = expected[i] * 1664525u + step + i;
        Assert.That(Kernels.Read<uint>(state), Is.EqualTo(expected));
    }

    [Test]
    public void WritesAndReads_BetweenDispatches_KeepTheirOrder()
    {
        using var program = Kernels.Create(_device, Kernels.Arithmetic, "Step");
        using var state = _device.CreateBuffer(4);
        var bound = Kernels.Bind(("State", state));
        byte[] uniforms = Kernels.Pack(program, ("Count", 1u), ("Increment", 1u));

        _device.Dispatch(program, uniforms, bound, 1, 1, 1);
        state.Write(BitConverter.GetBytes(10u));
        _device.Dispatch(program, uniforms, bound, 1, 1, 1);
        uint once = Kernels.Read<uint>(state)[0];
        _device.Dispatch(program, uniforms, bound, 1, 1, 1);

        Assert.That(once, Is.EqualTo(10u * 1664525u + 1));
        Assert.That(Kernels.Read<uint>(state)[0], Is.EqualTo(once * 1664525u + 1));
    }

    [Test]
    public void SmallWrites_BetweenDispatches_DoNotWait()
    {
        using var program = Kernels.Create(_device, Kernels.Arithmetic, "Step");
        using var state = _device.CreateBuffer(4);
        using var other = _device.CreateBuffer(4);
        var bound = Kernels.Bind(("State", state));
        byte[] uniforms = Kernels.Pack(program, ("Count", 1u), ("Increment", 1u));
        _device.Wait();
        long batch = _device.Recorder.Batch;

        for (uint i = 0; i < 3; i++)
        {
            other.Write(BitConverter.GetBytes(i));
            state.Write(BitConverter.GetBytes(i));
            state.Write(BitConverter.GetBytes(i + 1)); // overwrites the previous value
            _device.Dispatch(program, uniforms, bound, 1, 1, 1);
        }

        Assert.That(_device.Recorder.Batch, Is.EqualTo(batch), "nothing was run yet");
        Assert.That(Kernels.Read<uint>(state)[0], Is.EqualTo(3u * 1664525u + 1));
        Assert.That(Kernels.Read<uint>(other)[0], Is.EqualTo(2u));
    }

    [TestCase(1)]
    [TestCase(2_000_000)] // larger than what is copied instead of waited for
    public void Writes_WhileASubmittedBatchRuns_KeepTheirOrder(int written)
    {
        const int Count = 2_000_000;
        using var program = Kernels.Create(_device, Kernels.Arithmetic, "Step");
        using var state = _device.CreateBuffer(4 * Count);
        byte[] uniforms = Kernels.Pack(program, ("Count", (uint)Count), ("Increment", 1u));
        for (int i = 0; i < 3 * CommandRecorder.MaxDispatches / 2; i++)
            _device.Dispatch(program, uniforms, Kernels.Bind(("State", state)), Count / 32, 1, 1);
        state.Write(MemoryMarshal.AsBytes(Enumerable.Repeat(7u, written).ToArray().AsSpan()));
        _device.Dispatch(program, uniforms, Kernels.Bind(("State", state)), Count / 32, 1, 1);

        uint[] result = Kernels.Read<uint>(state);
        Assert.That(result[0], Is.EqualTo(7u * 1664525u + 1));
        uint last = 0, kept = (uint)(written == 1 ? 1 : written - 1);
        for (int i = 0; i < 3 * CommandRecorder.MaxDispatches / 2; i++)
            last = last * 1664525u + 1 + kept;
        Assert.That(result[kept], Is.EqualTo((written == 1 ? last : 7u) * 1664525u + 1 + kept));
    }

    [Test]
    public void ManyBuffersInTurn_AreEachBound()
    {
        const int Rounds = 30;
        using var program = Kernels.Create(_device, Kernels.Arithmetic, "Step");
        var states = Enumerable.Range(0, 80).Select(_ => _device.CreateBuffer(4)).ToArray();
        for (uint round = 0; round < Rounds; round++)
            for (uint i = 0; i < states.Length; i++)
                _device.Dispatch(program, Kernels.Pack(program, ("Count", 1u), ("Increment", i)),
                    Kernels.Bind(("State", states[i])), 1, 1, 1);
        for (uint i = 0; i < states.Length; i++)
        {
            uint expected = 0;
            for (int round = 0; round < Rounds; round++)
                expected = expected * 1664525u + i;
            Assert.That(Kernels.Read<uint>(states[i]), Is.EqualTo(new[] { expected }), $"buffer {i}");
        }
    }

    [Test]
    public void WriteAndRead_LargerThanTheStagingBuffer_AreWhole()
    {
        var data = new byte[20_000_003];
        new Random(1).NextBytes(data);
        using var buffer = _device.CreateBuffer(data.Length);
        buffer.Write(data);
        var back = new byte[data.Length];
        buffer.Read(back);
        Assert.That(back.AsSpan().SequenceEqual(data), Is.True);
    }

    [Test]
    public void WriteAndRead_OfAPart_LeaveTheRest()
    {
        using var buffer = _device.CreateBuffer(16);
        buffer.Write([1, 2, 3, 4], 4);
        var part = new byte[8];
        buffer.Read(part, 2);
        Assert.That(part, Is.EqualTo(new byte[] { 0, 0, 1, 2, 3, 4, 0, 0 }));
    }

    [Test]
    public void Buffers_DisposedRightAfterTheDispatch_WereUsedBefore()
    {
        using var program = Kernels.Create(_device, Kernels.Arithmetic, "Add");
        using var sum = _device.CreateBuffer(4);
        for (int i = 0; i < 100; i++)
        {
            using var a = Kernels.Buffer(_device, new float[] { i });
            using var b = Kernels.Buffer(_device, new float[] { 1 });
            _device.Dispatch(program, Kernels.Pack(program, ("Count", 1u)),
                Kernels.Bind(("Left", a), ("Right", b), ("Sum", sum)), 1, 1, 1);
        }
        Assert.That(Kernels.Read<float>(sum), Is.EqualTo(new[] { 100f }));
    }

    [Test]
    public void Structs_OfSixteenByteRows_AgreeWithCSharp()
    {
        var records = Enumerable.Range(0, 37).Select(i => new Record
        {
            X = i, Y = 2 * i, Z = 3 * i, Id = (uint)i, W0 = 1, W1 = 2, W2 = 3, W3 = i, CellX = i, CellY = -i,
            SpareX = 5, SpareY = 6
        }).ToArray();
        using var program = Kernels.Create(_device, Kernels.Structs, "Shift");
        using var input = Kernels.Buffer(_device, records);
        using var output = _device.CreateBuffer(input.Bytes);

        _device.Dispatch(program, [], Kernels.Bind(("Records", input), ("Shifted", output)), 3, 1, 1);

        Assert.That(program.Slots.Select(slot => slot.Stride), Is.All.EqualTo(Marshal.SizeOf<Record>()));
        var expected = records.Select(r => new Record
        {
            X = r.X + 1, Y = r.Y + 2, Z = r.Z + 3, Id = r.Id + 100, W0 = 2, W1 = 4, W2 = 6, W3 = 2 * r.W3,
            CellX = r.CellY, CellY = r.CellX, SpareX = 5, SpareY = 6,
        });
        Assert.That(Kernels.Read<Record>(output), Is.EqualTo(expected));
    }

    [Test]
    public void ByteAddressBuffers_Work()
    {
        using var program = Kernels.Create(_device, Kernels.Structs, "Bytes");
        using var words = Kernels.Buffer(_device, new uint[] { 1, 20, 300, 4000 });
        using var total = _device.CreateBuffer(4);
        _device.Dispatch(program, [], Kernels.Bind(("Words", words), ("Total", total)), 1, 1, 1);
        Assert.That(Kernels.Read<uint>(total), Is.EqualTo(new[] { 4321u }));
    }

    [Test]
    public void Rows_InAnyOrder_AreGathered()
    {
        const int Count = 1003; // not a multiple of the group size
        uint[] rows = Enumerable.Range(0, 4 * Count).Select(i => 0xfedc0000u + (uint)i).ToArray();
        uint[] order = Enumerable.Range(0, Count).Select(i => (uint)((i * 7) % Count)).ToArray();
        using var program = Kernels.Create(_device, Kernels.Buffers, "Gather");
        using var source = Kernels.Buffer(_device, rows);
        using var positions = Kernels.Buffer(_device, order);
        using var gathered = _device.CreateBuffer(16 * Count);

        _device.Dispatch(program, Kernels.Pack(program, ("_Count", (uint)Count)),
            Kernels.Bind(("_Rows", source), ("_Order", positions), ("_Gathered", gathered)), Count / 32 + 1, 1, 1);

        var slot = program.Slots.Single(candidate => candidate.Name == "_Rows");
        Assert.That((slot.Stride, slot.Element, slot.Writable), Is.EqualTo((16, "uint4", false)));
        var expected = order.SelectMany((row, i) => Enumerable.Range(0, 4)
            .Select(part => rows[4 * row + part] + (part == 3 ? (uint)i : 0)));
        Assert.That(Kernels.Read<uint>(gathered), Is.EqualTo(expected));
    }

    [Test]
    public void FifteenBuffers_AreEachReadOrWritten()
    {
        using var program = Kernels.Create(_device, Kernels.Buffers, "Crowd");
        var buffers = program.Slots.ToDictionary(slot => slot.Name, slot =>
            Kernels.Buffer(_device, slot.Writable ? new uint[4] : [(uint)(slot.Name[^1] - '0') + 1, 0, 0, 0]));

        _device.Dispatch(program, [], buffers, 1, 1, 1);

        Assert.That(buffers.Count, Is.EqualTo(15));
        Assert.That(new[] { "_Out0", "_Out1", "_Out2" }.Select(name => Kernels.Read<uint>(buffers[name])[0]),
            Is.EqualTo(new[] { 4321u, 8765u, 4321u }));
    }

    [Test]
    public void ZeroGroups_RunNothing()
    {
        using var program = Kernels.Create(_device, Kernels.Arithmetic, "Step");
        using var state = _device.CreateBuffer(4);
        _device.Dispatch(program, Kernels.Pack(program, ("Count", 1u), ("Increment", 5u)),
            Kernels.Bind(("State", state)), 0, 1, 1);
        Assert.That(Kernels.Read<uint>(state), Is.EqualTo(new[] { 0u }));
    }

    [Test]
    public void Device_ClosedFirst_LeavesBuffersAndProgramsHarmless()
    {
        var device = VulkanDevice.Open(null, _mapBuffers);
        var buffer = device.CreateBuffer(16);
        var program = Kernels.Create(device, Kernels.Arithmetic, "Step");
        device.Dispatch(program, Kernels.Pack(program, ("Count", 4u), ("Increment", 5u)),
            Kernels.Bind(("State", buffer)), 1, 1, 1);
        device.Dispose();
        device.Dispose();
        Assert.DoesNotThrow(buffer.Dispose);
        Assert.DoesNotThrow(program.Dispose);
        Assert.Throws<ObjectDisposedException>(() => buffer.Write(new byte[4]));
        Assert.Throws<ObjectDisposedException>(() => device.CreateBuffer(4));
    }

    struct Record
    {
        public float X, Y, Z; public uint Id;
        public float W0, W1, W2, W3;
        public int CellX, CellY; public float SpareX, SpareY;
    }
}
