namespace UnityEngine.Rendering;

public enum IndexFormat
{
    UInt16,
    UInt32,
}
