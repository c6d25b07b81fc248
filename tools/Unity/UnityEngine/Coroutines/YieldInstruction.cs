namespace UnityEngine;

public class YieldInstruction;

/// <summary>Goes on at the end of the frame, after LateUpdate and rendering.</summary>
public sealed class WaitForEndOfFrame : YieldInstruction;

/// <summary>Goes on after the next FixedUpdate.</summary>
public sealed class WaitForFixedUpdate : YieldInstruction;

/// <summary>Goes on in the first frame in which so much scaled time has passed.</summary>
public sealed class WaitForSeconds : YieldInstruction
{
    public WaitForSeconds(float seconds) => Seconds = seconds;

    internal float Seconds { get; }
}
