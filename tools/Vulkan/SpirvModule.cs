using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;

namespace Glint.Vulkan;

/// <summary>
/// The declarations of a SPIR-V module: names, decorations, types, constants, variables, entry point. Instructions are
/// skipped.
/// </summary>
sealed class SpirvModule
{
    const uint Magic = 0x07230203;
    const int HeaderWords = 5;

    // Word of OpTypeImage that holds the format, and formats.
    const int ImageFormat = 8;
    const uint Rgba32Float = 1, Rgba8 = 4;

    readonly Dictionary<uint, string> _names = [];
    readonly Dictionary<(uint Type, int Member), string> _memberNames = [];
    readonly Dictionary<(uint Id, Decoration Kind), uint> _decorations = [];
    readonly Dictionary<(uint Type, int Member, Decoration Kind), uint> _memberDecorations = [];

    internal string EntryPoint { get; private set; }
    internal (uint X, uint Y, uint Z) GroupSize { get; private set; }
    internal Dictionary<uint, SpirvType> Types { get; } = [];
    internal Dictionary<uint, uint> Constants { get; } = [];
    internal List<SpirvVariable> Variables { get; } = [];

    internal SpirvModule(ReadOnlySpan<byte> code)
    {
        if (code.Length < HeaderWords * 4 || code.Length % 4 != 0 || MemoryMarshal.Read<uint>(code) != Magic)
            throw new VulkanException($"a compiled kernel of {code.Length} bytes is not SPIR-V; build the tools again");
        var words = MemoryMarshal.Cast<byte, uint>(code);
        var last = Op.None;
        for (int at = HeaderWords; at < words.Length;)
        {
            int length = (int)(words[at] >> 16);
            if (length == 0 || at + length > words.Length)
                throw CutOff(code.Length);
            last = (Op)(words[at] & 0xffff);
            Read(last, words.Slice(at + 1, length - 1));
            at += length;
        }
        if (EntryPoint == null || last != Op.FunctionEnd)
            throw CutOff(code.Length);
    }

    /// <summary>
    /// A copy of a module whose pictures of four floats (RWTexture2D&lt;float4&gt;) have the format of
    /// <see cref="GpuImage"/>: HLSL names none, and glslang takes one of 16 bytes a pixel.
    /// </summary>
    internal static byte[] WithImageFormat(ReadOnlySpan<byte> code)
    {
        byte[] copy = code.ToArray();
        var words = MemoryMarshal.Cast<byte, uint>(copy.AsSpan());
        for (int at = HeaderWords; at < words.Length && words[at] >> 16 != 0; at += (int)(words[at] >> 16))
            if ((Op)(words[at] & 0xffff) == Op.TypeImage && words[at + ImageFormat] == Rgba32Float)
                words[at + ImageFormat] = Rgba8;
        return copy;
    }

    /// <summary>Whether a type is a picture of two dimensions that a kernel writes.</summary>
    internal bool IsStorageImage(uint type) =>
        Types[type] is { Op: Op.TypeImage, Operands: [_, 1, _, 0, 0, 2, Rgba8, ..] };

    internal string Name(uint id) => _names.GetValueOrDefault(id, "");
    internal string MemberName(uint type, int member) => _memberNames.GetValueOrDefault((type, member), "");
    internal bool Has(uint id, Decoration kind) => _decorations.ContainsKey((id, kind));
    internal uint Value(uint id, Decoration kind) => _decorations.GetValueOrDefault((id, kind));
    internal bool MemberHas(uint type, int member, Decoration kind) =>
        _memberDecorations.ContainsKey((type, member, kind));
    internal int MemberValue(uint type, int member, Decoration kind) =>
        (int)_memberDecorations.GetValueOrDefault((type, member, kind));

    void Read(Op op, ReadOnlySpan<uint> w)
    {
        switch (op)
        {
            case Op.Name: _names[w[0]] = Text(w[1..]); break;
            case Op.MemberName: _memberNames[(w[0], (int)w[1])] = Text(w[2..]); break;
            case Op.Decorate: _decorations[(w[0], (Decoration)w[1])] = w.Length > 2 ? w[2] : 1; break;
            case Op.MemberDecorate:
                _memberDecorations[(w[0], (int)w[1], (Decoration)w[2])] = w.Length > 3 ? w[3] : 1; break;
            case Op.EntryPoint: EntryPoint ??= Text(w[2..]); break;
            case Op.ExecutionMode when w[1] == 17: GroupSize = (w[2], w[3], w[4]); break; // LocalSize
            case Op.Constant: Constants[w[1]] = w[2]; break;
            case Op.Variable: Variables.Add(new SpirvVariable(w[1], w[0], (StorageClass)w[2])); break;
            case >= Op.TypeVoid and <= Op.TypePointer: Types[w[0]] = new SpirvType(op, w[1..].ToArray()); break;
        }
    }

    static VulkanException CutOff(int bytes) =>
        new($"a compiled kernel of {bytes} bytes is cut off; build the tools again");

    static string Text(ReadOnlySpan<uint> characters)
    {
        var bytes = MemoryMarshal.AsBytes(characters);
        return Encoding.UTF8.GetString(bytes[..bytes.IndexOf((byte)0)]);
    }
}

/// <summary>A type with its operands as in the SPIR-V specification, without the result.</summary>
sealed record SpirvType(Op Op, uint[] Operands);

readonly record struct SpirvVariable(uint Id, uint PointerType, StorageClass Storage);

enum Op
{
    None = 0, Name = 5, MemberName = 6, EntryPoint = 15, ExecutionMode = 16,
    TypeVoid = 19, TypeBool = 20, TypeInt = 21, TypeFloat = 22, TypeVector = 23, TypeMatrix = 24,
    TypeImage = 25, TypeArray = 28, TypeRuntimeArray = 29,
    TypeStruct = 30, TypePointer = 32, Constant = 43, FunctionEnd = 56,
    Variable = 59, Decorate = 71, MemberDecorate = 72,
}

enum Decoration
{
    BufferBlock = 3, RowMajor = 4, ArrayStride = 6, MatrixStride = 7, NonWritable = 24,
    Binding = 33, DescriptorSet = 34, Offset = 35,
}

enum StorageClass
{
    UniformConstant = 0, Uniform = 2, PushConstant = 9, StorageBuffer = 12,
}
