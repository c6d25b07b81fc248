namespace Glint.Vulkan;

/// <summary>A uniform as the kernel declares it, and where it lies in the bytes given to a dispatch.</summary>
/// <param name="Offset">First byte.</param>
/// <param name="Bytes">Bytes from the first to the last used one; the last element of an array is not padded.</param>
/// <param name="ArrayLength">Number of elements, 0 when it is no array.</param>
/// <param name="ArrayStride">Bytes from element to element (16 or more), 0 when it is no array.</param>
/// <param name="MatrixStride">
/// Bytes from column to column (from row to row when <paramref name="RowMajor"/>), 0 when it is no matrix.
/// </param>
/// <param name="Rows">Rows of a matrix, else 1.</param>
/// <param name="Columns">Columns of a matrix, components of a vector, 1 for a scalar, 0 for a struct.</param>
/// <param name="RowMajor">Declared row_major; HLSL's default is column by column.</param>
public sealed record UniformField(
    string Name, int Offset, int Bytes, int ArrayLength, int ArrayStride, int MatrixStride,
    int Rows, int Columns, bool RowMajor, ScalarKind Kind);

/// <summary>What the components of a uniform are; bool arrives as UInt.</summary>
public enum ScalarKind { Float, Int, UInt, Struct }
