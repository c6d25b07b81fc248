using UnityEngine;

namespace Glint.Host.Tests;

public sealed class MarkerOptions : ScriptableObject
{
    public float Frequency = 1f;
    public MarkerOptions Next;
}
