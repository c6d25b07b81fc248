using System;

namespace Glint.Editor
{
    /// <summary>What a command works on.</summary>
    [Flags]
    public enum InputKind
    {
        /// <summary>Nothing: the command takes no input.</summary>
        None = 0,

        /// <summary>A Unity scene: .unity.</summary>
        Scene = 1,

        /// <summary>A mesh file: .obj or .stl.</summary>
        MeshFile = 2,

        /// <summary>Either.</summary>
        File = Scene | MeshFile,

        /// <summary>The generated scene of a command that may be called without an input.</summary>
        BuiltIn = 4,

        /// <summary>Results folders, one or more.</summary>
        Folders = 8,

        /// <summary>A folder with results of a run or sweep.</summary>
        Results = 16,

        /// <summary>The name of a shell.</summary>
        Shell = 32,

        /// <summary>Whatever a command works on alone.</summary>
        Any = File | BuiltIn | Results
    }
}
