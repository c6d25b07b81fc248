using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>
    /// What a run or sweep worked on and with, for results.json. What is not known stays null and is written as null.
    /// </summary>
    public sealed class RunInfo
    {
        /// <summary>Scene or mesh file as an asset path or as the user gave it.</summary>
        public string ScenePath;

        /// <summary>
        /// The arguments of the command that asked for it, without where its files go;
        /// null for a run that no command began.
        /// </summary>
        public IReadOnlyList<string> Command;

        /// <summary>Object that was turned.</summary>
        public string TargetName;

        /// <summary>Objects and triangles traced.</summary>
        public long Objects, Triangles;

        /// <summary>Graphics device, and the interface it was used through ("Vulkan").</summary>
        public string DeviceName, GraphicsApi;

        /// <summary>Versions: of Glint, of Unity's API, and name and version of the program that ran.</summary>
        public string GlintVersion, UnityVersion, Host;

        /// <summary>Name and version of the operating system.</summary>
        public string OperatingSystem;

        /// <summary>When the run began, UTC.</summary>
        public DateTime StartedUtc;

        /// <summary>Wall time of the whole run in milliseconds.</summary>
        public double ElapsedMs;

        /// <summary>What the rows are of; null for a single pose.</summary>
        public SweepIdentity Sweep;

        /// <summary>Radar, receiver and sweep settings, in the order of the file; each name once.</summary>
        public readonly List<RunSetting> Settings = new List<RunSetting>();
    }
}
