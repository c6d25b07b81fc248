using System;
using System.Linq;
using Glint.Vulkan;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Host.Tests.Vulkan;

public sealed class ComputeShaderTests
{
    ComputeShader _arithmetic, _uniforms, _structs;

    [SetUp]
    public void LoadShaders()
    {
        _arithmetic = Load("Arithmetic", Kernels.Arithmetic);
        _uniforms = Load("Uniforms", Kernels.Uniforms);
        _structs = Load("Structs", Kernels.Structs);
    }

    [TearDown]
    public void DestroyShaders()
    {
        UnityEngine.Object.DestroyImmediate(_arithmetic);
        UnityEngine.Object.DestroyImmediate(_uniforms);
        UnityEngine.Object.DestroyImmediate(_structs);
    }

    [Test]
    public void Dispatch_WithBuffersOfBothKinds_Adds()
    {
        int add = _arithmetic.FindKernel("Add");
        using var left = new ComputeBuffer(3, 4);
        using var right = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 3, 4);
        using var sum = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 3, 4);
        left.SetData(new[] { 1f, 2f, 3f });
        right.SetData(new[] { 10f, 20f, 30f });
        _arithmetic.SetInt("Count", 3);
        _arithmetic.SetBuffer(add, "Left", left);
        _arithmetic.SetBuffer(add, Shader.PropertyToID("Right"), right);
        _arithmetic.SetBuffer(add, "Sum", sum);

        _arithmetic.Dispatch(add, 1, 1, 1);

        var result = new float[3];
        sum.GetData(result);
        Assert.That(result, Is.EqualTo(new[] { 11f, 22f, 33f }));
    }

    [Test]
    public void Uniforms_SetThroughEveryMethod_ArriveAsUnityLaysThemOut()
    {
        var matrix = new Matrix4x4();
        for (int i = 0; i < 16; i++)
            matrix[i / 4, i % 4] = 100 + i; // row by row
        using var output = new ComputeBuffer(256, 4);
        int echo = _uniforms.FindKernel("Echo");
        _uniforms.SetBuffer(echo, "Out", output);
        _uniforms.SetFloat("Real", 1.5f);
        _uniforms.SetInt("Signed", -7);
        _uniforms.SetInt("Unsigned", 9);
        _uniforms.SetBool("Yes", true);
        _uniforms.SetFloats("Pair", 10, 11);
        _uniforms.SetVector("Triple", new Vector4(20, 21, 22, 99));
        _uniforms.SetVector("Quad", new Vector4(30, 31, 32, 33));
        _uniforms.SetInts("Cell", -1, -2, -3);
        _uniforms.SetVectorArray("Reals",
            [new Vector4(40, 0, 0, 0), new Vector4(41, 0, 0, 0), new Vector4(42, 0, 0, 0)]);
        _uniforms.SetVectorArray("Quads", [new Vector4(50, 51, 52, 53), new Vector4(54, 55, 56, 57)]);
        _uniforms.SetMatrix("Columns", matrix);
        _uniforms.SetMatrixArray("Matrices", [Matrix4x4.identity, matrix]);
        _uniforms.SetMatrix("Affine", matrix);
        _uniforms.SetFloat("Inner", 60);
        _uniforms.SetInts("Mask", 61, 62, 63, 64);
        _uniforms.SetFloat("NoSuchUniform", 1); // ignored, as in Unity

        _uniforms.Dispatch(echo, 1, 1, 1);

        var result = new float[256];
        output.GetData(result);
        float[] rows = Enumerable.Range(100, 16).Select(i => (float)i).ToArray();
        float[] identity = Enumerable.Range(0, 16).Select(i => i % 5 == 0 ? 1f : 0).ToArray();
        float[][] expected =
        [
            [1.5f, -7, 9, 1, 10, 11, 20, 21, 22, 30, 31, 32, 33, -1, -2, -3, 40, 41, 42, 50,
                51, 52, 53, 54, 55, 56, 57],
            rows, new float[16], identity, rows, rows[..12], [60, 61, 62, 63, 64, 103],
        ];
        Assert.That(result[..132], Is.EqualTo(expected.SelectMany(part => part).Concat(new float[132]).Take(132)));
    }

    [Test]
    public void Uniforms_KeepTheirValuesBetweenDispatches()
    {
        int step = _arithmetic.FindKernel("Step");
        using var state = new ComputeBuffer(1, 4);
        _arithmetic.SetBuffer(step, "State", state);
        _arithmetic.SetInt("Count", 1);
        _arithmetic.SetInt("Increment", 3);
        _arithmetic.Dispatch(step, 1, 1, 1);
        _arithmetic.SetInt("Increment", 4);
        _arithmetic.Dispatch(step, 1, 1, 1);
        var result = new uint[1];
        state.GetData(result);
        Assert.That(result[0], Is.EqualTo(3u * 1664525u + 4));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Dispatch_WithABufferNotSetOrReleased_LogsItsNameAndIsSkipped(bool released)
    {
        int add = _arithmetic.FindKernel("Add");
        using var buffer = new ComputeBuffer(1, 4);
        _arithmetic.SetBuffer(add, "Left", buffer);
        _arithmetic.SetBuffer(add, "Sum", buffer);
        if (released)
        {
            var right = new ComputeBuffer(1, 4);
            _arithmetic.SetBuffer(add, "Right", right);
            right.Release();
        }
        using var log = new LogCapture();
        _arithmetic.Dispatch(add, 1, 1, 1);
        Assert.That(log.Messages, Is.EqualTo(
            new[] { (LogType.Error, "Compute shader (Arithmetic): Property (Right) at kernel index (0) is not set") }));
    }

    [TestCase(0, 1, 1)]
    [TestCase(1, -1, 1)]
    [TestCase(1, 1, 65536)]
    public void Dispatch_OfSuchGroups_LogsAnErrorAndIsSkipped(int x, int y, int z)
    {
        using var log = new LogCapture();
        _arithmetic.Dispatch(0, x, y, z);
        Assert.That(log.Messages.Select(message => message.Type), Is.EqualTo(new[] { LogType.Error }));
        Assert.That(log.Messages[0].Text, Does.StartWith("Thread group count"));
    }

    [Test]
    public void Dispatch_WithAStructOfAnotherSize_NamesBothStrides()
    {
        int loose = _structs.FindKernel("Loose");
        using var corners = new ComputeBuffer(2, 24); // two Vector3 in C#
        using var lengths = new ComputeBuffer(1, 4);
        _structs.SetBuffer(loose, "Corners", corners);
        _structs.SetBuffer(loose, "Lengths", lengths);
        var error = Assert.Throws<InvalidOperationException>(() => _structs.Dispatch(loose, 1, 1, 1));
        Assert.That(error.Message, Does.Contain("Corners as Corner of 32 bytes").And.Contain("stride is 24"));
    }

    [Test]
    public void RawBuffers_OfAnyStride_BindToByteAddressBuffers()
    {
        int bytes = _structs.FindKernel("Bytes");
        using var words = new ComputeBuffer(1, 16, ComputeBufferType.Raw);
        using var total = new GraphicsBuffer(GraphicsBuffer.Target.Raw, 1, 4);
        words.SetData(new[] { 1, 2, 3, 4 });
        _structs.SetBuffer(bytes, "Words", words);
        _structs.SetBuffer(bytes, "Total", total);
        _structs.Dispatch(bytes, 1, 1, 1);
        var result = new int[1];
        total.GetData(result);
        Assert.That(result[0], Is.EqualTo(10));
    }

    [Test]
    public void Kernels_AreFoundByName()
    {
        Assert.That(_arithmetic.FindKernel("Scale"), Is.EqualTo(2));
        Assert.That(_arithmetic.HasKernel("Subtract"), Is.False);
        Assert.That(_arithmetic.IsSupported(1), Is.True);
        Assert.Throws<ArgumentException>(() => _arithmetic.FindKernel("Subtract"));
        Assert.Throws<IndexOutOfRangeException>(() => _arithmetic.Dispatch(3, 1, 1, 1));
        _arithmetic.GetKernelThreadGroupSizes(2, out uint x, out uint y, out uint z);
        Assert.That((x, y, z), Is.EqualTo((8u, 4u, 2u)));
    }

    [Test]
    public void Device_ClosedAndOpenedAgain_RunsTheSameShader()
    {
        Uniforms_KeepTheirValuesBetweenDispatches();
        GraphicsDevice.Close();
        Uniforms_KeepTheirValuesBetweenDispatches();
    }

    [Test]
    public void NullDevice_SaysSoAndMakesNothing()
    {
        GraphicsDevice.Type = GraphicsDeviceType.Null;
        try
        {
            Assert.That(SystemInfo.graphicsDeviceType, Is.EqualTo(UnityEngine.Rendering.GraphicsDeviceType.Null));
            Assert.That(SystemInfo.supportsComputeShaders, Is.False);
            Assert.That(_arithmetic.IsSupported(0), Is.False);
            Assert.Throws<UnityException>(() => new ComputeBuffer(1, 4));
        }
        finally
        {
            GraphicsDevice.Type = GraphicsDeviceType.Vulkan;
        }
    }

    [Test]
    public void SystemInfo_IsThatOfTheDevice()
    {
        var device = GraphicsDevice.Current;
        Assert.That(SystemInfo.graphicsDeviceName, Is.EqualTo(device.Info.Name));
        Assert.That(SystemInfo.graphicsDeviceVersion, Does.StartWith("Vulkan 1."));
        Assert.That(SystemInfo.maxGraphicsBufferSize, Is.EqualTo(device.Limits.MaxStorageBufferRange));
        // the minimum that Vulkan guarantees
        Assert.That(SystemInfo.maxComputeWorkGroupSize, Is.GreaterThanOrEqualTo(128));
        Assert.That(SystemInfo.processorType, Is.Not.Empty);
    }

    static ComputeShader Load(string name, string path) => new(name, Sources.Root, path, ShaderLibrary.Kernels(path));
}
