using UnityEngine;

namespace Glint.Host;

/// <summary>A log message of a test, and whether it was expected.</summary>
internal sealed class ReceivedLog
{
    internal ReceivedLog(LogType type, string message)
    {
        Type = type;
        Message = message;
    }

    internal LogType Type { get; }

    internal string Message { get; }

    internal bool IsExpected { get; set; }

    internal bool Fails => Type is LogType.Error or LogType.Assert or LogType.Exception;

    public override string ToString() => $"[{Type}] {Message}";
}
