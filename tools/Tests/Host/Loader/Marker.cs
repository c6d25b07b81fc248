using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Serialization;

namespace Glint.Host.Tests;

/// <summary>A script with a field of each kind.</summary>
public sealed class Marker : MarkerBase, ISerializationCallbackReceiver
{
    public Transform Target;
    public Marker Other;
    public GameObject Model;
    public Mesh Shape;
    public MarkerOptions Settings;
    public TextAsset Notes;
    public float[] Numbers;
    public List<int> Packed;
    public bool[] Switches;
    public List<string> Words;
    public List<Transform> Targets;
    public MarkerPart[] Parts;
    public MarkerPart Main = new() { Length = 3f };
    public MarkerKind Kind = MarkerKind.Second;
    public LayerMask Layers;
    public Vector3 Vector;
    public Vector2Int Cell;
    public Quaternion Turn;
    public Color Colour;
    public Color32 Bytes;
    public Bounds Box;
    public Rect Area;
    public double Precise;
    public long Large;
    public ulong Unsigned;
    public string Text;
    public int Kept = 42;
    public static int Shared = 1;
    [SerializeReference] public MarkerPart Polymorphic;
    [NonSerialized] public int Skipped = 5;
    [FormerlySerializedAs("oldName")] public int Renamed;
    [field: SerializeField] public float Automatic { get; private set; }
    [SerializeField] float _hidden = 1f;
    float _private = 1f;

    public float Hidden => _hidden;

    public float Private => _private;

    public int Callbacks { get; private set; }

    /// <summary>Value of the reference at the time of the callback.</summary>
    public string OtherAtCallback { get; private set; }

    public void OnBeforeSerialize()
    {
    }

    public void OnAfterDeserialize()
    {
        Callbacks++;
        OtherAtCallback = ReferenceEquals(Other, null) ? null : Other.Text;
    }
}

public abstract class MarkerBase : MonoBehaviour
{
    [SerializeField] int _base = 1;

    public int Base => _base;
}

[Serializable]
public sealed class MarkerPart
{
    public float Length;
    public string Label;
    public Vector3 Offset;
}

public enum MarkerKind
{
    First,
    Second,
    Fourth = 4,
}
