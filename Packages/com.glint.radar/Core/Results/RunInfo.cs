using System;
using System.Collections.Generic;
using System.Numerics;

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
        /// The arguments of the command that asked for it, without where its files go;
        /// null for a run that no command began.
        /// </summary>
        public IReadOnlyList<string> Command;

        /// <summary>Makes images of range profiles; null: the processor does. Not written.</summary>
        public Func<IsarTransform, IReadOnlyList<Complex[]>, Complex[]> Backproject;

        /// <summary>Object that was turned.</summary>
        public string TargetName;

        /// <summary>Objects and triangles traced.</summary>
        public long Objects, Triangles;

        /// <summary>Names of the objects of contributions, by their numbers; null without contributions.</summary>
        public IReadOnlyList<string> ObjectNames;

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

    /// <summary>One setting of a run: a number with its unit, or a text.</summary>
    public readonly struct RunSetting
    {
        /// <summary>A setting that is a number.</summary>
        /// <param name="unit">Unit such as "Hz"; "1" for a plain number.</param>
        public RunSetting(string name, double number, string unit) =>
            (Name, Number, Unit, Text) = (name, number, unit, null);

        /// <summary>A setting that is a text.</summary>
        /// <param name="name">As in results.json.</param>
        /// <param name="text">Its value.</param>
        public RunSetting(string name, string text) =>
            (Name, Number, Unit, Text) = (name, 0, null, text);

        /// <summary>Names as in results.json: "max_bounces".</summary>
        public string Name { get; }

        /// <summary>The value in <see cref="Unit"/>, if that is not null.</summary>
        public double Number { get; }

        /// <summary>Null for a text.</summary>
        public string Unit { get; }

        /// <summary>Null for a number.</summary>
        public string Text { get; }
    }
}
