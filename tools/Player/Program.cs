using System;
using System.Globalization;
using Glint.Host;

namespace Glint.Player;

/// <summary>
/// glint-player FRAMES: the project that the program lies in as a player build of it. Prints what each frame puts on the
/// screen, a line each; the log goes to the error stream. Exit status: 0, 2 a wrong call.
/// </summary>
static class Program
{
    static int Main(string[] arguments)
    {
        if (arguments.Length != 1 || !int.TryParse(arguments[0], NumberStyles.None, CultureInfo.InvariantCulture, out int frames))
        {
            Console.Error.WriteLine("glint-player: give the number of frames to run, such as: glint-player 12");
            return 2;
        }
        LogSink.Writer = (type, message) => Console.Error.WriteLine($"[{type}] {message}");
        Project.Open(Project.FindRoot(AppContext.BaseDirectory));
        Engine.StartPlayer();
        for (int frame = 0; frame < frames; frame++)
        {
            Engine.Step();
            Console.Out.WriteLine(string.Join('\n', ScreenText.Texts).Replace("\n", " | "));
        }
        Engine.ExitPlayMode();
        return 0;
    }
}
