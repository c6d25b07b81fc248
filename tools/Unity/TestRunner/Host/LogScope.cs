using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host;

/// <summary>
/// Compares the log messages of one test, from any thread, with its expectations. Expectations match in the order in
/// which they were made, by messages before or after the call. Unexpected errors, assertions and exceptions fail the
/// test.
/// </summary>
internal sealed class LogScope : IDisposable
{
    static volatile LogScope _current;

    readonly LogScope _outer;
    readonly object _lock = new();
    readonly List<ReceivedLog> _received = new();
    readonly List<ReceivedLog> _failing = new();
    readonly Queue<ExpectedLog> _expected = new();

    LogScope() => _outer = _current;

    /// <summary>The innermost open scope, the only one that receives messages; null if none is open.</summary>
    internal static LogScope Innermost => _current;

    internal static LogScope Current
        => _current ?? throw new InvalidOperationException("LogAssert can only be used while a test, "
            + "its set-up or its tear-down runs");

    /// <summary>While true, logged errors do not fail the test.</summary>
    internal bool IgnoresFailing { get; set; }

    internal static void Open()
    {
        _current = new LogScope();
        Application.logMessageReceivedThreaded += _current.Receive;
    }

    public void Dispose()
    {
        Application.logMessageReceivedThreaded -= Receive;
        _current = _outer;
    }

    internal void Expect(ExpectedLog expectation)
    {
        lock (_lock)
            _expected.Enqueue(expectation);
    }

    /// <summary>The line that lists unexpected errors; null without any.</summary>
    internal string UnexpectedErrors()
    {
        lock (_lock)
        {
            Match();
            var unexpected = _failing.Where(log => !log.IsExpected).ToList();
            return unexpected.Count == 0 ? null : "Logged, but not expected (LogAssert.Expect): "
                + string.Join("; ", unexpected);
        }
    }

    /// <summary>The line that lists missing expected messages; null without any.</summary>
    internal string MissingLogs()
    {
        lock (_lock)
        {
            Match();
            return _expected.Count == 0 ? null : "Expected (LogAssert.Expect), but not logged: "
                + string.Join("; ", _expected);
        }
    }

    /// <exception cref="AssertionException">An unexpected message of any type was logged.</exception>
    internal void RequireAllExpected()
    {
        lock (_lock)
        {
            Match();
            var unexpected = _received.Where(log => !log.IsExpected).ToList();
            if (unexpected.Count > 0)
                throw new AssertionException("Logged, but not expected (LogAssert.NoUnexpectedReceived): "
                    + string.Join("; ", unexpected));
        }
    }

    void Receive(string message, string stackTrace, LogType type)
    {
        if (_current != this)
            return;
        var log = new ReceivedLog(type, message);
        lock (_lock)
        {
            _received.Add(log);
            if (log.Fails && !IgnoresFailing)
                _failing.Add(log);
        }
    }

    void Match()
    {
        foreach (var log in _received.Where(log => !log.IsExpected))
        {
            if (_expected.Count == 0)
                return;
            if (!_expected.Peek().Matches(log))
                continue;
            log.IsExpected = true;
            _expected.Dequeue();
        }
    }
}
