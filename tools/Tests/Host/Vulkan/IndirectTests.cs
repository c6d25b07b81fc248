using System;
using Glint.Vulkan;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests.Vulkan;

public sealed class IndirectTests
{
    const GraphicsBuffer.Target Arguments = GraphicsBuffer.Target.IndirectArguments | GraphicsBuffer.Target.Raw;

    ComputeShader _shader;
    int _plan, _mark;
    GraphicsBuffer _groups, _marks;

    [SetUp]
    public void LoadShader()
    {
        _shader = new ComputeShader(
            "Indirect", Sources.Root, Kernels.Indirect, ShaderLibrary.Kernels(Kernels.Indirect));
        (_plan, _mark) = (_shader.FindKernel("Plan"), _shader.FindKernel("Mark"));
        _groups = new GraphicsBuffer(Arguments, 6, 4);
        _marks = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 8, 4);
        _shader.SetBuffer(_plan, "_Groups", _groups);
        _shader.SetBuffer(_mark, "_Marks", _marks);
    }

    [TearDown]
    public void Release()
    {
        _groups.Release();
        _marks.Release();
        UnityEngine.Object.DestroyImmediate(_shader);
    }

    [Test]
    public void Groups_WrittenByAKernel_AreThoseThatRun()
    {
        foreach (int count in new[] { 3, 5 }) // the counts of the first round have run when the second overwrites them
        {
            _shader.SetInt("_Count", count);
            _shader.Dispatch(_plan, 1, 1, 1);
            _shader.DispatchIndirect(_mark, _groups, 12);
            _shader.DispatchIndirect(_mark, _groups); // no groups along x
        }
        Assert.That(Marks(), Is.EqualTo(new[] { 24, 24, 24, 12, 12, 0, 0, 0 }));
    }

    [Test]
    public void Groups_WrittenByTheHost_AreThoseOfTheirMoment()
    {
        _groups.SetData(new[] { 2, 1, 1 });
        _shader.DispatchIndirect(_mark, _groups);
        _groups.SetData(new[] { 1, 1, 1 });
        _shader.DispatchIndirect(_mark, _groups);
        Assert.That(Marks(), Is.EqualTo(new[] { 2, 1, 0, 0, 0, 0, 0, 0 }));
    }

    [Test]
    public void ComputeBuffer_HasGroupsToo()
    {
        using var groups = new ComputeBuffer(3, 4, ComputeBufferType.IndirectArguments);
        groups.SetData(new[] { 4, 1, 1 });
        _shader.DispatchIndirect(_mark, groups);
        Assert.That(Marks()[..5], Is.EqualTo(new[] { 1, 1, 1, 1, 0 }));
    }

    [Test]
    public void ArgumentBuffer_AlsoStructured_IsRefused()
    {
        const GraphicsBuffer.Target Both = GraphicsBuffer.Target.Structured | GraphicsBuffer.Target.IndirectArguments;
        var error = Assert.Throws<ArgumentException>(() => new GraphicsBuffer(Both, 3, 4));
        Assert.That(error.Message,
            Does.Contain("Structured and IndirectArguments").And.Contain("IndirectArguments | Raw"));
    }

    [Test]
    public void ArgumentBuffer_WithoutTheTarget_IsRefused()
    {
        using var raw = new GraphicsBuffer(GraphicsBuffer.Target.Raw, 3, 4);
        var error = Assert.Throws<ArgumentException>(() => _shader.DispatchIndirect(_mark, raw));
        Assert.That(error.Message, Does.Contain("kernel Mark").And.Contain("without IndirectArguments"));
        Assert.Throws<ArgumentNullException>(() => _shader.DispatchIndirect(_mark, (GraphicsBuffer)null));
    }

    [TestCase(2u)]
    [TestCase(16u)]
    [TestCase(uint.MaxValue - 3)]
    public void Offset_OddOrBeyondTheBuffer_IsRefused(uint offset)
    {
        var error = Assert.Throws<ArgumentException>(() => _shader.DispatchIndirect(_mark, _groups, offset));
        Assert.That(error.Message, Does.Contain("24 bytes").And.Contain($"{offset:N0}"));
    }

    [Test]
    public void Buffer_OfTheOtherKind_IsRefused()
    {
        _shader.SetBuffer(_plan, "_Groups", _marks);
        Assert.That(Assert.Throws<InvalidOperationException>(() => _shader.Dispatch(_plan, 1, 1, 1)).Message,
            Does.Contain("kernel Plan declares _Groups as a byte address buffer").And.Contain("add Raw"));
        _shader.SetBuffer(_mark, "_Marks", _groups);
        Assert.That(Assert.Throws<InvalidOperationException>(() => _shader.Dispatch(_mark, 1, 1, 1)).Message,
            Does.Contain("kernel Mark declares _Marks as a structured buffer").And.Contain("Structured"));
    }

    [Test]
    public void Buffer_OfBothKinds_BindsToBoth()
    {
        using var both = new GraphicsBuffer(GraphicsBuffer.Target.Structured | GraphicsBuffer.Target.Raw, 8, 4);
        _shader.SetInt("_Count", 7);
        _shader.SetBuffer(_plan, "_Groups", both);
        _shader.SetBuffer(_mark, "_Marks", both);
        _shader.Dispatch(_plan, 1, 1, 1);
        _shader.Dispatch(_mark, 1, 1, 1);
        var result = new int[8];
        both.GetData(result);
        Assert.That(result, Is.EqualTo(new[] { 1, 1, 1, 7, 2, 1, 0, 0 }));
    }

    [Test]
    public void Device_WithoutIndirectArguments_RefusesThem()
    {
        GraphicsDevice.HasIndirectArguments = false;
        try
        {
            Assert.That(SystemInfo.supportsIndirectArgumentsBuffer, Is.False);
            Assert.Throws<NotSupportedException>(() => _shader.DispatchIndirect(_mark, _groups));
        }
        finally
        {
            GraphicsDevice.HasIndirectArguments = true;
        }
        Assert.That(SystemInfo.supportsIndirectArgumentsBuffer, Is.True);
    }

    int[] Marks()
    {
        var marks = new int[8];
        _marks.GetData(marks);
        return marks;
    }
}
