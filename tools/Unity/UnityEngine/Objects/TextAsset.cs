using System;
using System.IO;
using System.Text;
using Glint.Host;

namespace UnityEngine;

/// <summary>A text file (.txt, .csv, .json, .xml, .md, .bytes ...) as an asset.</summary>
public class TextAsset : Object
{
    byte[] _bytes = Array.Empty<byte>();

    public TextAsset()
    {
    }

    public TextAsset(string text) => _bytes = Encoding.UTF8.GetBytes(text ?? "");

    public TextAsset(ReadOnlySpan<byte> bytes) => _bytes = bytes.ToArray();

    public byte[] bytes => (byte[])Contents.Clone();

    public long dataSize => Contents.Length;

    public string text
    {
        get
        {
            using var reader = new StreamReader(new MemoryStream(Contents), Encoding.UTF8);
            return reader.ReadToEnd();
        }
    }

    byte[] Contents
    {
        get
        {
            EnsureAlive();
            return _bytes;
        }
    }

    public override string ToString() => text;

    internal override void CopyFrom(Object source, CloneMap map)
    {
        base.CopyFrom(source, map);
        _bytes = ((TextAsset)source)._bytes;
    }
}
