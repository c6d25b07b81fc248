using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Glint.Host;

/// <summary>
/// Problems that do not change the simulation. Each is reported once for all its objects, after loading.
/// </summary>
internal sealed class LoadWarnings
{
    readonly Dictionary<(string File, string What), List<string>> _subjects = new();
    readonly List<(string File, string What)> _order = new();

    internal void Add(ObjectRecord record, string what)
    {
        (string, string) key = (record.File, what);
        if (!_subjects.TryGetValue(key, out List<string> subjects))
        {
            _subjects.Add(key, subjects = new List<string>());
            _order.Add(key);
        }
        subjects.Add(record.Subject);
    }

    internal void Clear()
    {
        _subjects.Clear();
        _order.Clear();
    }

    internal void Report()
    {
        foreach ((string file, string what) in _order)
        {
            List<string> subjects = _subjects[(file, what)];
            string more = subjects.Count > 1 ? $" and {subjects.Count - 1} more" : "";
            Debug.LogWarning(OneLine($"{file}: {subjects[0]}{more}: {what}"));
        }
        Clear();
    }

    // Names may contain line breaks and terminal control characters.
    static string OneLine(string text) => string.Concat(text.Select(letter => char.IsControl(letter) ? ' ' : letter));
}
