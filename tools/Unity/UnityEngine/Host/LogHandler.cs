using System;
using System.Globalization;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>Receives every log call and passes it to listeners, then to the sink.</summary>
internal sealed class LogHandler : ILogHandler
{
    public void LogFormat(LogType logType, Object context, string format, params object[] args)
    {
        string message = string.Format(CultureInfo.InvariantCulture, format, args);
        Application.RaiseLog(message, "", logType);
        LogSink.Write(logType, message);
    }

    public void LogException(Exception exception, Object context)
    {
        string message = $"{exception.GetType().Name}: {exception.Message}";
        Application.RaiseLog(message, exception.StackTrace ?? "", LogType.Exception);
        LogSink.Write(LogType.Exception, $"{message}\n{exception.StackTrace}".TrimEnd());
    }
}
