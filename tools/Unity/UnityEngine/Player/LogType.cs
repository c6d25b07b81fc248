namespace UnityEngine;

public enum LogType
{
    Error,
    Assert,
    Warning,
    Log,
    Exception,
}

public enum StackTraceLogType
{
    None,
    ScriptOnly,
    Full,
}

public enum LogOption
{
    None,
    NoStacktrace,
}
