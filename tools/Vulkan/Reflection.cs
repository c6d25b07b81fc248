using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Vulkan;

/// <summary>The resources that a kernel needs, with the names of its HLSL source.</summary>
/// <remarks>
/// glslang turns a StructuredBuffer into a block with one runtime array, and gathers the globals of a file in a block
/// named $Global. Several constant buffers follow one another, each at a multiple of <see cref="BlockAlignment"/>.
/// </remarks>
sealed class Reflection
{
    /// <summary>
    /// The largest minUniformBufferOffsetAlignment that Vulkan allows, so that offsets are the same on every device.
    /// </summary>
    internal const int BlockAlignment = 256;

    readonly SpirvModule _module;
    readonly List<BufferSlot> _buffers = [];
    readonly List<UniformBlock> _blocks = [];
    readonly Dictionary<string, UniformField> _uniforms = [];

    internal string EntryPoint => _module.EntryPoint;
    internal (uint X, uint Y, uint Z) GroupSize => _module.GroupSize;
    internal IReadOnlyList<BufferSlot> Buffers => _buffers;

    /// <summary>In the order of their bindings.</summary>
    internal UniformBlock[] Blocks => _blocks.OrderBy(block => block.Binding).ToArray();

    internal IReadOnlyDictionary<string, UniformField> Uniforms => _uniforms;
    internal int UniformBytes { get; private set; }

    /// <summary>The next multiple of <see cref="BlockAlignment"/>.</summary>
    internal static int Align(int bytes) => (bytes + BlockAlignment - 1) / BlockAlignment * BlockAlignment;

    internal Reflection(ReadOnlySpan<byte> code)
    {
        _module = new SpirvModule(code);
        foreach (var variable in _module.Variables)
        {
            if (variable.Storage is not (StorageClass.Uniform or StorageClass.StorageBuffer
                or StorageClass.UniformConstant or StorageClass.PushConstant))
                continue; // inputs, locals and groupshared memory
            uint block = _module.Types[variable.PointerType].Operands[1];
            string name = _module.Name(variable.Id) is { Length: > 0 } own ? own : _module.Name(block);
            if (_module.IsStorageImage(block))
            {
                _buffers.Add(new BufferSlot(name, 0, "float4", true)
                { Binding = _module.Value(variable.Id, Decoration.Binding) });
                continue;
            }
            if (_module.Types[block].Op != Op.TypeStruct || variable.Storage == StorageClass.PushConstant)
                throw new VulkanException($"kernel {EntryPoint}: {name} is a texture, sampler, buffer array or push "
                    + "constant; only structured and byte address buffers, RWTexture2D<float4> and uniforms are "
                    + "supported");
            if (_module.Value(variable.Id, Decoration.DescriptorSet) != 0)
                throw new VulkanException($"kernel {EntryPoint}: {name} has a register space; leave register() out");

            uint binding = _module.Value(variable.Id, Decoration.Binding);
            if (variable.Storage == StorageClass.StorageBuffer || _module.Has(block, Decoration.BufferBlock))
                AddBuffer(name, binding, block, variable.Id);
            else
                AddBlock(binding, block);
        }
    }

    void AddBuffer(string name, uint binding, uint block, uint variable)
    {
        uint array = _module.Types[block].Operands[0];
        bool readOnly = _module.MemberHas(block, 0, Decoration.NonWritable)
            || _module.Has(variable, Decoration.NonWritable);
        _buffers.Add(new BufferSlot(name, (int)_module.Value(array, Decoration.ArrayStride),
            TypeName(_module.Types[array].Operands[0]), !readOnly)
        { Binding = binding });
    }

    void AddBlock(uint binding, uint block)
    {
        int start = Align(UniformBytes);
        uint[] members = _module.Types[block].Operands;
        int end = 0;
        for (int member = 0; member < members.Length; member++)
        {
            var field = Field(block, member, members[member], start);
            _uniforms[field.Name] = field;
            end = Math.Max(end, field.Offset - start + field.Bytes);
        }
        int bytes = (end + 15) / 16 * 16;
        _blocks.Add(new UniformBlock(binding, start, bytes));
        UniformBytes = start + bytes;
    }

    UniformField Field(uint block, int member, uint typeId, int start)
    {
        int arrayLength = 0, arrayStride = 0, matrixStride = 0, rows = 1, columns = 1;
        var type = _module.Types[typeId];
        if (type.Op == Op.TypeArray)
        {
            arrayLength = (int)_module.Constants[type.Operands[1]];
            arrayStride = (int)_module.Value(typeId, Decoration.ArrayStride);
            typeId = type.Operands[0];
            type = _module.Types[typeId];
        }
        int elementBytes = Size(typeId, block, member);
        // SPIR-V's matrix is the transpose of the HLSL one: its columns are HLSL's rows, and its "row major" is HLSL's
        // default column-major order.
        bool rowMajor = false;
        if (type.Op == Op.TypeMatrix)
        {
            rows = (int)type.Operands[1];
            matrixStride = _module.MemberValue(block, member, Decoration.MatrixStride);
            rowMajor = !_module.MemberHas(block, member, Decoration.RowMajor);
            type = _module.Types[type.Operands[0]];
        }
        if (type.Op == Op.TypeVector)
        {
            columns = (int)type.Operands[1];
            type = _module.Types[type.Operands[0]];
        }
        var kind = type switch
        {
            { Op: Op.TypeFloat } => ScalarKind.Float,
            { Op: Op.TypeInt, Operands: [_, 1] } => ScalarKind.Int,
            { Op: Op.TypeInt } => ScalarKind.UInt,
            _ => ScalarKind.Struct,
        };
        int bytes = arrayLength > 1 ? (arrayLength - 1) * arrayStride + elementBytes : elementBytes;
        return new UniformField(_module.MemberName(block, member),
            start + _module.MemberValue(block, member, Decoration.Offset), bytes,
            arrayLength, arrayStride, matrixStride, rows, kind == ScalarKind.Struct ? 0 : columns, rowMajor, kind);
    }

    /// <summary>
    /// Bytes of a type from its first to its last used byte. Block and member give the storage of a matrix.
    /// </summary>
    int Size(uint typeId, uint block, int member)
    {
        var type = _module.Types[typeId];
        switch (type.Op)
        {
            case Op.TypeInt or Op.TypeFloat:
                return (int)type.Operands[0] / 8;
            case Op.TypeVector:
                return (int)type.Operands[1] * Size(type.Operands[0], block, member);
            case Op.TypeMatrix:
                int vectors = (int)type.Operands[1], components = (int)_module.Types[type.Operands[0]].Operands[1];
                (int lines, int perLine) = _module.MemberHas(block, member, Decoration.RowMajor)
                    ? (components, vectors)
                    : (vectors, components);
                return (lines - 1) * _module.MemberValue(block, member, Decoration.MatrixStride) + perLine * 4;
            case Op.TypeArray:
                int length = (int)_module.Constants[type.Operands[1]];
                return (length - 1) * (int)_module.Value(typeId, Decoration.ArrayStride)
                    + Size(type.Operands[0], block, member);
            case Op.TypeStruct:
                int last = type.Operands.Length - 1;
                return _module.MemberValue(typeId, last, Decoration.Offset) + Size(type.Operands[last], typeId, last);
            default:
                return 4;
        }
    }

    string TypeName(uint typeId)
    {
        var type = _module.Types[typeId];
        return type.Op switch
        {
            Op.TypeFloat => "float",
            Op.TypeInt => type.Operands[1] == 1 ? "int" : "uint",
            Op.TypeVector => TypeName(type.Operands[0]) + type.Operands[1],
            Op.TypeMatrix => TypeName(_module.Types[type.Operands[0]].Operands[0]) + type.Operands[1] + "x"
                + _module.Types[type.Operands[0]].Operands[1],
            _ => _module.Name(typeId),
        };
    }
}
