using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

internal static class PngFile
{
    /// <summary>Pixels row by row from the top, of a picture without filters in 8 bits and four channels.</summary>
    internal static (int width, int height, Color32[] pixels) Read(byte[] png)
    {
        Assert.That(png.AsSpan(1, 3).ToArray(), Is.EqualTo("PNG"u8.ToArray()));
        using var packed = new MemoryStream();
        for (int at = 8, length; at < png.Length; at += 12 + length)
        {
            length = BinaryPrimitives.ReadInt32BigEndian(png.AsSpan(at));
            if (Encoding.ASCII.GetString(png, at + 4, 4) == "IDAT")
                packed.Write(png, at + 8, length);
        }
        packed.Position = 0;
        using var data = new MemoryStream();
        using (var rows = new ZLibStream(packed, CompressionMode.Decompress))
            rows.CopyTo(data);
        byte[] bytes = data.ToArray();
        int width = BinaryPrimitives.ReadInt32BigEndian(png.AsSpan(16)),
            height = BinaryPrimitives.ReadInt32BigEndian(png.AsSpan(20));
        Assert.That(bytes, Has.Length.EqualTo(height * (1 + 4 * width)));
        return (width, height, Enumerable.Range(0, width * height)
            .Select(i => i / width * (1 + 4 * width) + 1 + i % width * 4)
            .Select(at => new Color32(bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3])).ToArray());
    }
}
