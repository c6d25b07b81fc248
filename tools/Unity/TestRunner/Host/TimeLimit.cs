using System;
using NUnit.Framework.Internal;

namespace Glint.Host;

/// <summary>Time limit of a routine.</summary>
internal static class TimeLimit
{
    internal static readonly TimeSpan Default = TimeSpan.FromSeconds(180);

    /// <summary>
    /// The limit that [Timeout] sets on the test, its fixture or its assembly. NUnit enforces such a limit by
    /// abandoning the test on another thread, where it would step frames into the next test.
    /// This class removes the attribute's limit and checks it between frames.
    /// </summary>
    internal static TimeSpan TakeFrom(Test test)
    {
        var context = TestExecutionContext.CurrentContext;
        var milliseconds = context.TestCaseTimeout;
        context.TestCaseTimeout = 0;
        if (test.Properties.ContainsKey(PropertyNames.Timeout))
        {
            milliseconds = (int)test.Properties.Get(PropertyNames.Timeout);
            test.Properties.Set(PropertyNames.Timeout, 0);
        }
        return milliseconds > 0 ? TimeSpan.FromMilliseconds(milliseconds) : Default;
    }
}
