using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>One command: its help texts, its options, and which of them it requires.</summary>
    public sealed class Command
    {
        internal Command(string name, string summary)
        {
            Name = name;
            Summary = summary;
        }

        /// <summary>Name on the command line: "sweep".</summary>
        public string Name { get; }

        /// <summary>One sentence.</summary>
        public string Summary { get; }

        /// <summary>Further sentences for the help, one paragraph each.</summary>
        public IReadOnlyList<string> Notes { get; internal set; } = new string[0];

        /// <summary>Kind of the command's argument; none for a command without one.</summary>
        public InputKind Inputs { get; internal set; } = InputKind.File;

        /// <summary>Whether it uses a built-in scene when no input is given.</summary>
        public bool HasBuiltIn => (Inputs & InputKind.BuiltIn) != 0;

        /// <summary>The options, in the order of the help.</summary>
        public IReadOnlyList<Option> Options { get; internal set; }

        /// <summary>
        /// The options that must be given, each for the inputs it goes with;
        /// one that needs others, only with one of these.
        /// </summary>
        public IReadOnlyList<Option> Required { get; internal set; } = new Option[0];

        /// <summary>Options of which one at least must be given; empty when there are none.</summary>
        public IReadOnlyList<Option> OneOf { get; internal set; } = new Option[0];

        /// <summary>Name of the method for Unity's -executeMethod; null if Unity lacks the command.</summary>
        public string UnityMethod { get; internal set; }

        /// <summary>Whether it works in a Unity project, on a graphics device.</summary>
        public bool NeedsProject { get; set; } = true;

        /// <summary>
        /// Does what a command line of it says; returns the exit code. Null where the host does not have the command.
        /// </summary>
        public Func<CommandLine, IProgressSink, int> Handler { get; set; }

        /// <summary>Examples: the arguments after "glint", and their effect.</summary>
        public IReadOnlyList<KeyValuePair<string, string>> Examples { get; internal set; }

        /// <summary>Name of its arguments: INPUT, [INPUT], DIR... or SHELL; null if it takes none.</summary>
        public string InputName => Inputs == InputKind.None ? null : Inputs == InputKind.Shell ? "SHELL" : Inputs
            == InputKind.Folders ? "DIR..." : HasBuiltIn ? "[INPUT]" : "INPUT";

        /// <summary>The command's usage in one line.</summary>
        public string Usage => string.Join(" ", new[] { "glint", Name, InputName }
            .Concat(OneOf.Take(1).Concat(Required.Where(option => option.Needs.Count == 0))
                .Select(option => $"{option.Flag} {option.ValueName}")).Append("[options]")
            .Where(word => word != null));
    }

    /// <summary>Kinds of input of a command.</summary>
    [Flags]
    public enum InputKind
    {
        /// <summary>No input.</summary>
        None = 0,

        /// <summary>A Unity scene: .unity.</summary>
        Scene = 1,

        /// <summary>A mesh file: .obj or .stl.</summary>
        MeshFile = 2,

        /// <summary>A scene or a mesh file.</summary>
        File = Scene | MeshFile,

        /// <summary>The built-in scene of a command with optional input.</summary>
        BuiltIn = 4,

        /// <summary>Results folders, one or more.</summary>
        Folders = 8,

        /// <summary>A folder with results of a run or sweep.</summary>
        Results = 16,

        /// <summary>The name of a shell.</summary>
        Shell = 32,

        /// <summary>Any single input.</summary>
        Any = File | BuiltIn | Results
    }
}
