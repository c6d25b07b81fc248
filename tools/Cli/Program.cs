using System.Threading;
using Glint.Host;
using Glint.Vulkan;

namespace Glint.Cli;

static class Program
{
    static int Main(string[] arguments)
    {
        var terminal = new Terminal();
        int reports = 0;
        ComputeProgram.Compiling += device =>
        {
            if (Interlocked.Increment(ref reports) == 1)
                terminal.Report($"compiling kernels for {device.Name}: the first run on a device takes longer");
        };
        try
        {
            return new Shell(terminal).Run(arguments);
        }
        finally
        {
            // Mesa writes compiled kernels to its cache on a thread that only closing the device waits for.
            GraphicsDevice.Close();
        }
    }
}
