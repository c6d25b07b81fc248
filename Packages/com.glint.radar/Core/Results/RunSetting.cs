namespace Glint.Core
{
    /// <summary>One setting of a run: a number with its unit, or a text.</summary>
    public readonly struct RunSetting
    {
        /// <summary>A setting that is a number.</summary>
        /// <param name="unit">Unit such as "Hz"; "1" for a plain number.</param>
        public RunSetting(string name, double number, string unit)
        {
            Name = name;
            Number = number;
            Unit = unit;
            Text = null;
        }

        /// <summary>A setting that is a text.</summary>
        /// <param name="name">As in results.json.</param>
        /// <param name="text">Its value.</param>
        public RunSetting(string name, string text)
        {
            Name = name;
            Number = 0;
            Unit = null;
            Text = text;
        }

        /// <summary>As in results.json: "max_bounces".</summary>
        public string Name { get; }

        /// <summary>The value in <see cref="Unit"/>, if that is not null.</summary>
        public double Number { get; }

        /// <summary>Null for a text.</summary>
        public string Unit { get; }

        /// <summary>Null for a number.</summary>
        public string Text { get; }
    }
}
