using System;
using System.Linq;
using Glint.Vulkan;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Glint.Host.Tests.Vulkan;

public sealed class RenderTextureTests
{
    const string Path = "tools/Tests/Host/Shaders/Textures.compute";

    // Neither side is a multiple of the group's, nor are the rows of a multiple of 16 bytes.
    const int Width = 37, Height = 13;

    ComputeShader _shader;
    RenderTexture _texture;

    [SetUp]
    public void Make()
    {
        _shader = new ComputeShader("Textures", Sources.Root, Path, ShaderLibrary.Kernels(Path));
        _texture = Texture();
        Assert.That(_texture.Create(), Is.True);
    }

    [TearDown]
    public void Destroy()
    {
        UnityEngine.Object.DestroyImmediate(_shader);
        UnityEngine.Object.DestroyImmediate(_texture);
    }

    [Test]
    public void Kernel_WritesPixels_ThatAreReadBackRowByRow()
    {
        Paint(_texture, new Vector4(0, 0, 0.5f, 2));
        var pixels = Read(_texture);
        Assert.That(pixels, Has.Length.EqualTo(Width * Height));
        for (int i = 0; i < pixels.Length; i++)
            // 0.5 is between two levels; more than 1 is 1.
            Assert.That((pixels[i].r, pixels[i].g, pixels[i].a), Is.EqualTo((i % Width, i / Width, 255)), $"pixel {i}");
        Assert.That(pixels.Select(pixel => (int)pixel.b).Distinct().Single(), Is.EqualTo(127).Or.EqualTo(128));
    }

    [Test]
    public void NewTexture_IsBlackAndTransparent() =>
        Assert.That(Read(_texture).Select(pixel => pixel.r | pixel.g | pixel.b | pixel.a), Is.All.Zero);

    [Test]
    public void Readback_HasThePixelsOfItsMoment()
    {
        Paint(_texture, default);
        var request = AsyncGPUReadback.Request(_texture);
        Paint(_texture, new Vector4(0, 0, 1, 1));
        request.WaitForCompletion();
        Assert.That(request.GetData<Color32>()[0].b, Is.Zero);
        Assert.That(Read(_texture)[0].b, Is.EqualTo(255));
    }

    [Test]
    public void TextureThatIsNotCreated_IsNotSet()
    {
        using var log = new LogCapture();
        _texture.Release();
        Assert.That(_texture.IsCreated(), Is.False);
        Paint(_texture, default);
        Assert.That(log.Messages.Single().Text, Does.Contain("Property (_Target)").And.Contain("not set"));
        Assert.That(AsyncGPUReadbackOf(_texture), Throws.InvalidOperationException);
    }

    [Test]
    public void WhatTheHostLacks_IsRefused()
    {
        Assert.That(() => new RenderTexture(4, 4, 24, GraphicsFormat.R8G8B8A8_UNorm),
            Throws.InstanceOf<NotSupportedException>());
        Assert.That(() => new RenderTexture(4, 4, 0, GraphicsFormat.R8G8B8A8_SRGB),
            Throws.InstanceOf<NotSupportedException>());
        Assert.That(() => new RenderTexture(0, 4, 0, GraphicsFormat.R8G8B8A8_UNorm), Throws.ArgumentException);
        Assert.That(() => _texture.enableRandomWrite = false, Throws.InvalidOperationException);
        Assert.That(() => _shader.SetTexture(0, "_Target", new Texture2D(4, 4, TextureFormat.RGBA32, false)),
            Throws.ArgumentException);
        Assert.That(SystemInfo.IsFormatSupported(GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormatUsage.LoadStore));
        Assert.That(!SystemInfo.IsFormatSupported(GraphicsFormat.R8G8B8A8_SRGB, GraphicsFormatUsage.LoadStore));
    }

    static Action AsyncGPUReadbackOf(RenderTexture texture) => () => AsyncGPUReadback.Request(texture);

    static RenderTexture Texture() =>
        new(Width, Height, 0, GraphicsFormat.R8G8B8A8_UNorm) { enableRandomWrite = true };

    void Paint(RenderTexture texture, Vector4 colour)
    {
        using var size = new ComputeBuffer(2, 4);
        int paint = _shader.FindKernel("Paint");
        _shader.SetTexture(paint, "_Target", texture);
        _shader.SetBuffer(paint, "_Size", size);
        _shader.SetVector("_Colour", colour);
        _shader.Dispatch(paint, (Width + 7) / 8, (Height + 7) / 8, 1);
        if (!texture.IsCreated())
            return;
        var sides = new int[2];
        size.GetData(sides);
        Assert.That(sides, Is.EqualTo(new[] { Width, Height }));
    }

    static Color32[] Read(RenderTexture texture)
    {
        var request = AsyncGPUReadback.Request(texture);
        request.WaitForCompletion();
        return request.GetData<Color32>().ToArray();
    }
}
