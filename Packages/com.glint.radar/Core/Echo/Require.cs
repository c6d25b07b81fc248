namespace Glint.Core
{
    /// <summary>Refusals of numbers that are out of their ranges.</summary>
    static class Require
    {
        public static void Positive(string owner, string name, double value, string unit)
        {
            if (!(value > 0 && value < double.PositiveInfinity))
                throw new GlintException($"{owner}: the {name} is {RadarSettings.Text(value)} {unit}, "
                    + "it must be above 0 and finite");
        }

        public static void Within(string owner, string name, double value, string unit, Interval range)
        {
            if (!range.Contains(value))
                throw new GlintException($"{owner}: the {name} is {RadarSettings.Text(value)}{Space(unit)}{unit}, "
                    + $"it must be {range}");
        }

        public static void Within(string owner, Measure measure, object settings)
        {
            double value = measure.Of(settings);
            if (!measure.Range.Contains(value))
                throw new GlintException($"{owner}: {measure.Title.ToLowerInvariant()} {RadarSettings.Text(value)}"
                    + $"{Space(measure.Unit)}{measure.Unit} must be {measure.Range}: {measure.Help}");
        }

        public static void Count(string owner, string name, int value, int max) =>
            Within(owner, name, value, "", Interval.Closed(1, max));

        public static void Equal(string owner, string name, int value, int expected)
        {
            if (value != expected)
                throw new GlintException($"{owner}: {value} {name}, {expected} are needed");
        }

        static string Space(string unit) => unit.Length == 0 ? "" : " ";
    }
}
