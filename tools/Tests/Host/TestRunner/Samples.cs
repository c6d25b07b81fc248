using System.Collections;
using System.Collections.Generic;

namespace Glint.Host.Tests.TestRunner;

/// <summary>
/// Fixtures that other tests run. They are generic, so that NUnit does not find them; half of them fail on purpose.
/// </summary>
internal static partial class Samples<T>
{
    internal static readonly List<string> Trace = new();

    static IEnumerator Says(params string[] texts)
    {
        foreach (var text in texts)
        {
            Trace.Add(text);
            yield return null;
        }
    }

    [UnityTestAction]
    public abstract class Sample
    {
    }
}
