using System;

namespace Glint.Core
{
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
