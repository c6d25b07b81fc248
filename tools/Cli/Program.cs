using Glint.Host;

namespace Glint.Cli;

static class Program
{
    static int Main(string[] arguments)
    {
        try
        {
            return new Shell(new Terminal()).Run(arguments);
        }
        finally
        {
            // Mesa writes compiled kernels to its cache on a thread that only closing the device waits for.
            GraphicsDevice.Close();
        }
    }
}
