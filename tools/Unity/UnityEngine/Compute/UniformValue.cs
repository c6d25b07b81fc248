namespace Glint.Host;

/// <summary>The value of a uniform of a ComputeShader.</summary>
internal sealed class UniformValue
{
    internal byte[] Bytes;

    /// <summary>Number of times the value was set.</summary>
    internal int Version;
}
