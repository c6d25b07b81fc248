namespace UnityEngine;

// The types that Unity.Mathematics converts from and to; nothing here computes with them.
public struct Vector2
{
    public float x, y;

    public Vector2(float x, float y) => (this.x, this.y) = (x, y);
}

public struct Vector3
{
    public float x, y, z;

    public Vector3(float x, float y, float z) => (this.x, this.y, this.z) = (x, y, z);
}

public struct Vector4
{
    public float x, y, z, w;

    public Vector4(float x, float y, float z, float w) => (this.x, this.y, this.z, this.w) = (x, y, z, w);
}

public struct Quaternion
{
    public float x, y, z, w;

    public Quaternion(float x, float y, float z, float w) => (this.x, this.y, this.z, this.w) = (x, y, z, w);
}

public readonly struct Matrix4x4
{
    readonly Vector4 _column0, _column1, _column2, _column3;

    public Matrix4x4(Vector4 column0, Vector4 column1, Vector4 column2, Vector4 column3) =>
        (_column0, _column1, _column2, _column3) = (column0, column1, column2, column3);

    public Vector4 GetColumn(int index) => index switch
    {
        0 => _column0,
        1 => _column1,
        2 => _column2,
        _ => _column3
    };
}
