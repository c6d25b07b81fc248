namespace Unity.Mathematics;

public partial struct float2
{
    public static implicit operator UnityEngine.Vector2(float2 v) => new(v.x, v.y);
    public static implicit operator float2(UnityEngine.Vector2 v) => new(v.x, v.y);
}

public partial struct float3
{
    public static implicit operator UnityEngine.Vector3(float3 v) => new(v.x, v.y, v.z);
    public static implicit operator float3(UnityEngine.Vector3 v) => new(v.x, v.y, v.z);
}

public partial struct float4
{
    public static implicit operator UnityEngine.Vector4(float4 v) => new(v.x, v.y, v.z, v.w);
    public static implicit operator float4(UnityEngine.Vector4 v) => new(v.x, v.y, v.z, v.w);
}
