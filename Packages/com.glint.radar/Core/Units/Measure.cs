using System;
using System.Globalization;
using System.Reflection;

namespace Glint.Core
{
    /// <summary>
    /// A number among settings: the field that holds it, its range and its words,
    /// for validation, command line and inspector.
    /// </summary>
    public sealed class Measure
    {
        readonly FieldInfo _field;

        /// <param name="field">The field among the settings.</param>
        /// <param name="title">"Storey Height": "storey height" in messages, --storey-height on a command line.</param>
        /// <param name="unit">Empty for a plain number.</param>
        /// <param name="help">A sentence or more.</param>
        internal Measure(FieldInfo field, string title, string unit, Interval range, string help)
        {
            _field = field;
            (Title, Unit, Range, Help) = (title, unit, range, help);
        }

        /// <summary>Its label, in title case.</summary>
        public string Title { get; }

        /// <summary>Unit; empty for a plain number.</summary>
        public string Unit { get; }

        /// <summary>Its meaning.</summary>
        public string Help { get; }

        /// <summary>The allowed range.</summary>
        public Interval Range { get; }

        /// <summary>Whether it is a whole number.</summary>
        public bool IsWhole => _field.FieldType == typeof(int);

        /// <summary>Name of the field, label and tooltip, as an inspector shows them.</summary>
        public (string field, string label, string tooltip) Row =>
            (_field.Name, Unit.Length == 0 ? Title : $"{Title} ({Unit})", $"{Help} Allowed: {Range}.");

        /// <summary>The value among settings.</summary>
        public double Of(object settings) =>
            Convert.ToDouble(_field.GetValue(settings), CultureInfo.InvariantCulture);

        /// <summary>Sets it.</summary>
        /// <param name="value">A double, of a whole number an int.</param>
        public void Set(object settings, object value) => _field.SetValue(settings, value);
    }
}
