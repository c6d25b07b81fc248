using System.Globalization;
using System.Linq;

namespace UnityEngine;

/// <summary>
/// Checks of a Transform's values: one that is not finite is refused with Unity's message, and the old value is kept.
/// </summary>
public partial class Transform
{
    /// <summary>Values from a file, which Unity does not check.</summary>
    internal void Load(Vector3 localPosition, Quaternion localRotation, Vector3 localScale)
    {
        _localPosition = localPosition;
        _localRotation = localRotation.normalized;
        _localScale = localScale;
        MarkChanged();
    }

    bool Accepts(string property, Vector3 value) => Accepts(property, property, value.x, value.y, value.z);

    // Unity's message calls both rotations 'rotation'.
    bool Accepts(string property, Quaternion value) =>
        Accepts(property, "rotation", value.x, value.y, value.z, value.w);

    bool Accepts(string property, string input, params float[] numbers)
    {
        EnsureAlive();
        if (numbers.All(float.IsFinite))
            return true;
        string shown = string.Join(", ", numbers.Select(number => number.ToString("F6", CultureInfo.InvariantCulture)));
        Debug.LogError(
            $"transform.{property} assign attempt for '{name}' is not valid. Input {input} is {{ {shown} }}.", this);
        return false;
    }
}
