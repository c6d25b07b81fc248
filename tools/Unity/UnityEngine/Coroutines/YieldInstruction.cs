namespace UnityEngine;

public class YieldInstruction;

/// <summary>Resumes at the end of the frame, after LateUpdate and rendering.</summary>
public sealed class WaitForEndOfFrame : YieldInstruction;

/// <summary>Resumes after the next FixedUpdate.</summary>
public sealed class WaitForFixedUpdate : YieldInstruction;

/// <summary>Resumes in the first frame after this scaled time.</summary>
public sealed class WaitForSeconds : YieldInstruction
{
    public WaitForSeconds(float seconds) => Seconds = seconds;

    internal float Seconds { get; }
}
