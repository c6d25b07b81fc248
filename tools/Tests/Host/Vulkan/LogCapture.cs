using System;
using System.Collections.Generic;
using UnityEngine;

namespace Glint.Host.Tests.Vulkan;

/// <summary>Collects log messages during its lifetime.</summary>
sealed class LogCapture : IDisposable
{
    internal LogCapture() => Application.logMessageReceived += Add;

    internal List<(LogType Type, string Text)> Messages { get; } = [];

    public void Dispose() => Application.logMessageReceived -= Add;

    void Add(string text, string stackTrace, LogType type) => Messages.Add((type, text));
}
