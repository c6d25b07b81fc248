using Glint.Host;

namespace UnityEngine;

public sealed class Shader : Object
{
    Shader()
    {
    }

    /// <summary>The host does not render: every name has a shader.</summary>
    public static Shader Find(string name) => new() { Name = name };

    public static int PropertyToID(string name) => PropertyIds.Get(name);
}
