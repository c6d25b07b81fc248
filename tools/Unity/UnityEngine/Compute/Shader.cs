using Glint.Host;

namespace UnityEngine;

public sealed class Shader : Object
{
    Shader()
    {
    }

    public static int PropertyToID(string name) => PropertyIds.Get(name);
}
