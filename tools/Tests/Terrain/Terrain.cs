namespace UnityEngine;

/// <summary>In the place of Unity's own for a test: the host lacks it.</summary>
public sealed class Terrain : MonoBehaviour
{
}
