namespace Glint.Vulkan;

/// <summary>A uniform of a kernel, and its position in the bytes of a dispatch.</summary>
/// <param name="Offset">First byte.</param>
/// <param name="Bytes">Bytes from the first to the last used one; the last element of an array is not padded.</param>
/// <param name="ArrayLength">Number of elements; 0 if it is not an array.</param>
/// <param name="ArrayStride">Bytes from element to element (16 or more); 0 if it is not an array.</param>
/// <param name="MatrixStride">
/// Bytes from column to column (from row to row if <paramref name="RowMajor"/>); 0 if it is not a matrix.
/// </param>
/// <param name="Rows">Rows of a matrix, else 1.</param>
/// <param name="Columns">Columns of a matrix, components of a vector, 1 for a scalar, 0 for a struct.</param>
/// <param name="RowMajor">Declared row_major; HLSL's default is column by column.</param>
public sealed record UniformField(
    string Name, int Offset, int Bytes, int ArrayLength, int ArrayStride, int MatrixStride,
    int Rows, int Columns, bool RowMajor, ScalarKind Kind);

/// <summary>Type of a uniform's components; bool is UInt.</summary>
public enum ScalarKind { Float, Int, UInt, Struct }
