using System;

namespace Glint.Core
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

        /// <summary>Whatever there is to trace.</summary>
        Any = File | BuiltIn,

        /// <summary>Results folders, one or more.</summary>
        Folders = 8
    }
}
