using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>
    /// A number among settings: the field that holds it, its range and its words,
    /// for validation, command line and inspector.
    /// </summary>
    public sealed class Measure
    {
        readonly Func<object, double> _value;

        /// <param name="field">Name of the field that holds it, a double or an int.</param>
        /// <param name="value">The field's value among settings.</param>
        /// <param name="title">"Storey Height": "storey height" in messages, --storey-height on a command line.</param>
        /// <param name="unit">Empty for a plain number.</param>
        /// <param name="help">A sentence or more.</param>
        internal Measure(string field, Func<object, double> value, string title, string unit, Interval range,
            string help)
        {
            _value = value;
            (Field, Title, Unit, Range, Help) = (field, title, unit, range, help);
        }

        /// <summary>Name of the field.</summary>
        public string Field { get; }

        /// <summary>Its label, in title case.</summary>
        public string Title { get; }

        /// <summary>Unit; empty for a plain number.</summary>
        public string Unit { get; }

        /// <summary>Its meaning.</summary>
        public string Help { get; }

        /// <summary>The allowed range.</summary>
        public Interval Range { get; }

        /// <summary>Name of the field, label and tooltip, as an inspector shows them.</summary>
        public (string field, string label, string tooltip) Row =>
            (Field, Unit.Length == 0 ? Title : $"{Title} ({Unit})", $"{Help} Allowed: {Range}.");

        /// <summary>The value among settings.</summary>
        public double Of(object settings) => _value(settings);
    }

    /// <summary>The numbers of settings of one type.</summary>
    sealed class MeasureList<TSettings> : List<Measure>
    {
        public void Add(string field, Func<TSettings, double> value, string title, string unit, Interval range,
            string help) =>
            Add(new Measure(field, settings => value((TSettings)settings), title, unit, range, help));

        public void Add(string field, Func<TSettings, double> value, string title, string unit, double from, double to,
            string help) => Add(field, value, title, unit, Interval.Closed(from, to), help);
    }
}
