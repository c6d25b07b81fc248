using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>A script with a number of each kind, and structs with initialisers.</summary>
public sealed class Gauge : MonoBehaviour
{
    public int Whole;
    public uint Count;
    public byte Small;
    public short Short;
    public long Long;
    public ulong Unsigned;
    public float Single;
    public double Double;
    public MarkerKind Kind;
    public uint[] Counts;
    public LayerMask Layers = ~0;
    public Vector2 Size = new(3f, 3f);
    public Rect Area = new(1f, 2f, 3f, 4f);
    public Bounds Box = new(Vector3.one, 2f * Vector3.one);
}
