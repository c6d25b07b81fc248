using Glint.Host;

namespace UnityEngine;

/// <summary>A name and a shader; the host does not render.</summary>
public class Material : Object
{
    Shader _shader;

    public Material(Shader shader)
    {
        _shader = shader;
        Name = shader == null ? "" : shader.name;
    }

    public Material(Material source) => CopyFrom(source, null);

    internal Material()
    {
    }

    public Shader shader
    {
        get
        {
            EnsureAlive();
            return _shader;
        }
        set
        {
            EnsureAlive();
            _shader = value;
        }
    }

    public bool enableInstancing { get; set; }

    /// <summary>The renderer whose material property made this copy.</summary>
    internal Renderer InstanceOf { get; init; }

    public void CopyPropertiesFromMaterial(Material mat) => enableInstancing = mat.enableInstancing;

    internal override void CopyFrom(Object source, CloneMap map)
    {
        base.CopyFrom(source, map);
        _shader = ((Material)source)._shader;
        enableInstancing = ((Material)source).enableInstancing;
    }
}
