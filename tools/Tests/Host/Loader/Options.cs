using UnityEngine;

namespace Glint.Host.Tests;

public sealed class Options : ScriptableObject
{
    public float Frequency = 1f;
    public Options Next;
}
