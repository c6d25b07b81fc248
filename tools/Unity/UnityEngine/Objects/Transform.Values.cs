using System.Globalization;
using System.Linq;

namespace UnityEngine;

/// <summary>
/// What a Transform takes: a value that is not finite is refused with Unity's own words, and the old one stays.
/// </summary>
public partial class Transform
{
    /// <summary>Values from a file, which Unity takes as they are.</summary>
    internal void Load(Vector3 localPosition, Quaternion localRotation, Vector3 localScale)
    {
        _localPosition = localPosition;
        _localRotation = localRotation.normalized;
        _localScale = localScale;
        MarkChanged();
    }

    bool Accepts(string property, Vector3 value) => Accepts(property, property, value.x, value.y, value.z);

    // Both rotations are called 'rotation' where the input is shown.
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
