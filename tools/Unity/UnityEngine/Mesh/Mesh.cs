using Glint.Host;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh : Object
{
    MeshContents _contents = new();

    internal MeshContents Contents
    {
        get
        {
            EnsureAlive();
            return _contents;
        }
    }

    public bool isReadable => Contents.IsReadable;
    public int vertexCount => Contents.Vertices.Length;
    public Bounds bounds { get => Contents.Bounds; set => Contents.Bounds = value; }

    /// <summary>A change clears the index buffer: set it before the indices.</summary>
    public IndexFormat indexFormat
    {
        get => Contents.IndexFormat;
        set
        {
            if (value == Contents.IndexFormat)
                return;
            Contents.IndexFormat = value;
            int count = subMeshCount;
            subMeshCount = 0;
            subMeshCount = count;
        }
    }

    /// <summary>For loaders: sets the contents without a check.</summary>
    internal void Load(MeshContents contents) => _contents = contents;

    public void Clear() => Clear(true);

    public void Clear(bool keepVertexLayout)
    {
        if (CanAccess("vertices"))
            _contents = new MeshContents { IndexFormat = keepVertexLayout ? Contents.IndexFormat : IndexFormat.UInt16 };
    }

    public void MarkDynamic() => EnsureAlive();
    public void MarkModified() => EnsureAlive();

    public void UploadMeshData(bool markNoLongerReadable)
    {
        if (markNoLongerReadable)
            Contents.IsReadable = false;
    }

    public bool HasVertexAttribute(VertexAttribute attr) => Contents.Has(attr);

    internal override void CopyFrom(Object source, CloneMap map)
    {
        base.CopyFrom(source, map);
        _contents = ((Mesh)source)._contents.Copy();
    }

    bool CanAccess(string what)
    {
        if (Contents.IsReadable)
            return true;
        Debug.LogError(Refusal(what), this);
        return false;
    }

    string Refusal(string what)
    {
        return $"Not allowed to access {what} on mesh '{name}' (isReadable is false; "
            + "Read/Write must be enabled in import settings)";
    }
}
