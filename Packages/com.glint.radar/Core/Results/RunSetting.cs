namespace Glint.Core
{
    /// <summary>One setting of a run: a number with its unit, or a text.</summary>
    public readonly struct RunSetting
    {
        /// <param name="unit">Unit such as "Hz"; "1" for a plain number.</param>
        public RunSetting(string name, double number, string unit)
        {
            Name = name;
            Number = number;
            Unit = unit;
            Text = null;
        }

        public RunSetting(string name, string text)
        {
            Name = name;
            Number = 0;
            Unit = null;
            Text = text;
        }

        public string Name { get; }

        /// <summary>The value in <see cref="Unit"/>, when <see cref="Unit"/> is given.</summary>
        public double Number { get; }

        /// <summary>Null for a text.</summary>
        public string Unit { get; }

        /// <summary>Null for a number.</summary>
        public string Text { get; }
    }
}
