namespace Glint.Cli;

static class Program
{
    static int Main(string[] arguments) => new Shell(new Terminal()).Run(arguments);
}
