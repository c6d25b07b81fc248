using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;
using System.Runtime.InteropServices;
using System.Text;

namespace UnityEngine;

public enum FilterMode
{
    Point,
    Bilinear,
    Trilinear,
}

public enum TextureFormat
{
    RGB24 = 3,
    RGBA32 = 4,
}

public class Texture : Object
{
    protected Texture()
    {
    }

    public virtual int width { get; set; }

    public virtual int height { get; set; }

    public FilterMode filterMode { get; set; }
}

/// <summary>Stores colours for tests; the host does not show them.</summary>
public sealed class Texture2D : Texture
{
    public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain)
    {
        this.width = width;
        this.height = height;
    }

    internal Color32[] Pixels { get; private set; }

    public void SetPixels32(Color32[] colors)
    {
        if (colors.Length != width * height)
            throw new ArgumentException($"{colors.Length} colours for {width} x {height} pixels", nameof(colors));
        Pixels = colors;
    }

    public void Apply()
    {
    }
}

public static class ImageConversion
{
    static readonly byte[] Signature = [137, 80, 78, 71, 13, 10, 26, 10];

    /// <summary>8 bits each of red, green, blue and opacity, whatever the format.</summary>
    public static byte[] EncodeToPNG(this Texture2D tex)
    {
        using MemoryStream png = new(), data = new();
        using (var packed = new ZLibStream(data, CompressionLevel.Fastest, true))
            for (int y = tex.height - 1; y >= 0; y--)
            {
                packed.WriteByte(0); // no filter
                packed.Write(MemoryMarshal.AsBytes(tex.Pixels.AsSpan(y * tex.width, tex.width)));
            }
        var header = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, tex.width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), tex.height);
        (header[8], header[9]) = (8, 6);
        png.Write(Signature);
        WriteChunk(png, "IHDR", header);
        WriteChunk(png, "IDAT", data.ToArray());
        WriteChunk(png, "IEND", []);
        return png.ToArray();
    }

    static void WriteChunk(Stream png, string kind, byte[] data)
    {
        byte[] chunk = [.. Encoding.ASCII.GetBytes(kind), .. data];
        var number = new byte[4];
        BinaryPrimitives.WriteInt32BigEndian(number, data.Length);
        png.Write(number);
        png.Write(chunk);
        BinaryPrimitives.WriteUInt32BigEndian(number, Checksum(chunk));
        png.Write(number);
    }

    // CRC-32 as PNG has it.
    static uint Checksum(byte[] chunk)
    {
        uint sum = uint.MaxValue;
        foreach (byte item in chunk)
        {
            sum ^= item;
            for (int bit = 0; bit < 8; bit++)
                sum = sum >> 1 ^ (sum & 1) * 0xedb88320;
        }
        return ~sum;
    }
}
