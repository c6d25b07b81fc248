using System;
using System.Globalization;

namespace UnityEngine;

public class Logger : ILogger
{
    public Logger(ILogHandler logHandler) => this.logHandler = logHandler;

    public ILogHandler logHandler { get; set; }
    public bool logEnabled { get; set; } = true;
    public LogType filterLogType { get; set; } = LogType.Log;

    /// <summary>
    /// Exceptions pass any filter; other types are filtered by severity, the order of the values except Exception.
    /// </summary>
    public bool IsLogTypeAllowed(LogType logType) =>
        logEnabled
        && (logType == LogType.Exception || (filterLogType != LogType.Exception && logType <= filterLogType));

    public void Log(LogType logType, object message) => Write(logType, null, message, null);

    public void Log(LogType logType, object message, Object context) => Write(logType, null, message, context);

    public void Log(LogType logType, string tag, object message) => Write(logType, tag, message, null);

    public void Log(LogType logType, string tag, object message, Object context) =>
        Write(logType, tag, message, context);

    public void Log(object message) => Write(LogType.Log, null, message, null);

    public void Log(string tag, object message) => Write(LogType.Log, tag, message, null);

    public void Log(string tag, object message, Object context) => Write(LogType.Log, tag, message, context);

    public void LogWarning(string tag, object message) => Write(LogType.Warning, tag, message, null);

    public void LogWarning(string tag, object message, Object context) => Write(LogType.Warning, tag, message, context);

    public void LogError(string tag, object message) => Write(LogType.Error, tag, message, null);

    public void LogError(string tag, object message, Object context) => Write(LogType.Error, tag, message, context);

    public void LogFormat(LogType logType, string format, params object[] args) =>
        LogFormat(logType, null, format, args);

    public void LogFormat(LogType logType, Object context, string format, params object[] args)
    {
        if (IsLogTypeAllowed(logType))
            logHandler.LogFormat(logType, context, format, args);
    }

    public void LogException(Exception exception) => LogException(exception, null);

    public void LogException(Exception exception, Object context)
    {
        if (logEnabled)
            logHandler.LogException(exception, context);
    }

    void Write(LogType logType, string tag, object message, Object context)
    {
        if (!IsLogTypeAllowed(logType))
            return;
        string text = message is IFormattable formattable
            ? formattable.ToString(null, CultureInfo.InvariantCulture)
            : message?.ToString() ?? "Null";
        if (tag is null)
            logHandler.LogFormat(logType, context, "{0}", text);
        else
            logHandler.LogFormat(logType, context, "{0}: {1}", tag, text);
    }
}
