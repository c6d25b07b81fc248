using System;
using System.IO;
using Glint.Cli;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>Ctrl-C while a command works, by the exit code of its work.</summary>
public sealed class CancelledProductTests
{
    [TestCase(0)]
    [TestCase(1)]
    public void Work_ThatWasCompleteWhenItWasStopped_HasItsExitCode(int code) => Assert.That(Execute(code), Is.EqualTo(code));

    [Test]
    public void Work_ThatWasStopped_IsCancelled() =>
        Assert.That(() => Execute(Batch.Cancelled), Throws.InstanceOf<OperationCanceledException>());

    static int Execute(int code)
    {
        var terminal = TestShell.Quiet(TextWriter.Null, TextWriter.Null);
        using var cancellation = new Cancellation(terminal);
        var product = new Cli.Product(terminal);
        // The next product sets its own.
        Commands.Verify.Handler = (_, _) =>
        {
            cancellation.Press();
            return code;
        };
        return product.Execute(CommandLine.Parse(Commands.Verify, ["Scenes/CornerReflector.unity"]), cancellation);
    }
}
