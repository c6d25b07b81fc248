namespace UnityEngine;

public enum LogType
{
    Error,
    Assert,
    Warning,
    Log,
    Exception,
}

public enum LogOption
{
    None,
    NoStacktrace,
}
