using System;
using System.Collections.Generic;
using System.IO;
using System.Reflection;
using System.Threading;
using Glint.Core;
using NUnit.Framework.Api;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace Glint.Tests.Mono;

/// <summary>
/// Runs the tests of this assembly that are not slow with NUnit's own runner; the last line is "N passed, N failed". With
/// <c>--hold FOLDER</c> it opens a results folder and holds it until it is killed.
/// </summary>
static class Program
{
    // The long computations are of double precision, which is the same under Mono.
    static readonly TestFilter NotSlow = TestFilter.FromXml("<filter><not><cat>Slow</cat></not></filter>");

    static int Main(string[] arguments)
    {
        if (arguments.Length == 2 && arguments[0] == "--hold")
            return HoldFolder(arguments[1]);
        var runner = new NUnitTestAssemblyRunner(new DefaultTestAssemblyBuilder());
        runner.Load(Assembly.GetExecutingAssembly(), new Dictionary<string, object>());
        var result = runner.Run(new Listener(Console.Out), NotSlow);
        int failed = result.FailCount + result.SkipCount + result.InconclusiveCount;
        // A fixture whose set-up fails counts no test.
        if (failed == 0 && (result.PassCount == 0 || result.ResultState.Status != TestStatus.Passed))
            failed = 1;
        Console.WriteLine($"{result.PassCount} passed, {failed} failed");
        return failed == 0 ? 0 : 1;
    }

    static int HoldFolder(string folder)
    {
        try
        {
            using (ResultsFolder.Open(folder))
                Thread.Sleep(Timeout.Infinite);
            return 0;
        }
        catch (GlintException error)
        {
            Console.Error.WriteLine(error.Message);
            return error.ExitCode;
        }
    }

    /// <param name="output">Kept, since NUnit takes the console's during a test.</param>
    sealed class Listener(TextWriter output) : ITestListener
    {
        public void TestFinished(ITestResult result)
        {
            if (!result.HasChildren && result.ResultState.Status != TestStatus.Passed)
                output.WriteLine($"{result.ResultState} {result.FullName}\n{result.Message}\n{result.StackTrace}");
        }

        public void TestStarted(ITest test)
        {
        }

        public void TestOutput(TestOutput text)
        {
        }

        public void SendMessage(TestMessage message)
        {
        }
    }
}
