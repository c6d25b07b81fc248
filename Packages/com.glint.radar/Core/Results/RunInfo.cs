using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>
    /// Input and environment of a run or sweep, for results.json. Unknown values are null and written as null.
    /// </summary>
    public sealed class RunInfo
    {
        /// <summary>Scene or mesh file as an asset path or as the user gave it.</summary>
        public string ScenePath;

        /// <summary>
        /// The command line, as <see cref="CommandLine.Arguments"/>, without its output folder; null for a run that was
        /// not started by a command.
        /// </summary>
        public IReadOnlyList<string> Command;

        /// <summary>Object that was turned.</summary>
        public string TargetName;

        /// <summary>Objects and triangles traced.</summary>
        public long Objects, Triangles;

        /// <summary>Graphics device, and its API ("Vulkan").</summary>
        public string DeviceName, GraphicsApi;

        /// <summary>Versions: of Glint, of Unity's API, and name and version of the program that ran.</summary>
        public string GlintVersion, UnityVersion, Host;

        /// <summary>Name and version of the operating system.</summary>
        public string OperatingSystem;

        /// <summary>Start of the run, UTC.</summary>
        public DateTime StartedUtc;

        /// <summary>Wall time of the whole run in milliseconds.</summary>
        public double ElapsedMs;

        /// <summary>Identity of the sweep; null for a single pose.</summary>
        public SweepIdentity Sweep;

        /// <summary>Radar, receiver and sweep settings, in the order of the file; each name once.</summary>
        public readonly List<RunSetting> Settings = new List<RunSetting>();
    }
}
