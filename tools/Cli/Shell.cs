using System;
using Glint.Core;
using Glint.Editor;
using Glint.Vulkan;

namespace Glint.Cli;

/// <summary>The command as a process: parses, runs, and reports each failure as one line and an exit code.</summary>
sealed class Shell(Terminal terminal)
{
    const int Failure = 1;
    const string TraceVariable = "GLINT_TRACE";

    public int Run(string[] arguments)
    {
        var tree = new CommandTree(terminal, new Product(terminal).Execute);
        string help = "glint --help";
        try
        {
            return tree.Invoke(arguments, command => help = $"glint {command.Name} --help");
        }
        catch (UsageException error)
        {
            return Fail($"{error.Message} (see {help})", error, error.ExitCode);
        }
        catch (GlintException error)
        {
            return Fail(error.Message, error, error.ExitCode);
        }
        catch (VulkanException error)
        {
            return Fail(error.Message, error, Failure);
        }
        catch (OperationCanceledException error)
        {
            return Fail("stopped", error, Batch.Cancelled);
        }
        catch (Exception error)
        {
            string trace = IsTracing ? "" : $" (set {TraceVariable}=1 to see where)";
            return Fail($"internal error: {error.GetType().Name}: {error.Message}{trace}", error, Failure);
        }
    }

    int Fail(string message, Exception error, int exitCode)
    {
        // Messages of libraries may have several lines.
        terminal.Error.WriteLine("glint: " + string.Join(" ",
            message.Split(['\r', '\n'], StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries)));
        if (IsTracing)
            terminal.Error.WriteLine(error);
        return exitCode;
    }

    static bool IsTracing => Environment.GetEnvironmentVariable(TraceVariable) == "1";
}
