using System;
using System.Collections.Generic;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>One option of the commands: a row of the table <see cref="Options"/>.</summary>
    public abstract class Option
    {
        private protected Option(string name, string valueName)
        {
            Name = name;
            ValueName = valueName;
        }

        /// <summary>Name without the dashes: "target".</summary>
        public string Name { get; }

        /// <summary>Name as written on a command line: "--target".</summary>
        public string Flag => "--" + Name;

        /// <summary>Placeholder of the value in the help: "NAME".</summary>
        public string ValueName { get; }

        /// <summary>One or two sentences for the user, units included.</summary>
        public string Help { get; internal set; }

        /// <summary>Range of the value as text; null if unrestricted.</summary>
        public string Range { get; internal set; }

        /// <summary>
        /// Values for completion; empty if there are too many, or only file names.
        /// </summary>
        public IReadOnlyList<string> Choices { get; internal set; } = Array.Empty<string>();

        /// <summary>Text of the default value; null if there is none.</summary>
        public string DefaultText { get; internal set; }

        /// <summary>
        /// Text of the value if the option is given without one; null if it needs a value.
        /// </summary>
        public string ImpliedText { get; internal set; }

        /// <summary>Whether it takes no value.</summary>
        public bool IsSwitch { get; internal set; }

        /// <summary>Heading of the option in the help.</summary>
        public string Group { get; internal set; }

        /// <summary>The inputs to which the option applies.</summary>
        public InputKind Inputs { get; internal set; } = InputKind.Any;

        /// <summary>Message if the option is given with another input.</summary>
        public string Refusal { get; internal set; }

        /// <summary>
        /// Options of which one must be given with this one; may be empty.
        /// </summary>
        public IReadOnlyList<Option> Needs { get; internal set; } = Array.Empty<Option>();

        /// <summary>Options that exclude this one, each with the reason.</summary>
        public IReadOnlyList<(Option option, string reason)> Excludes { get; internal set; } =
            Array.Empty<(Option, string)>();

        /// <summary>Unity's own means for the purpose; null for options of both hosts.</summary>
        public string UnityRemedy { get; internal set; }

        /// <summary>The default value.</summary>
        public abstract object DefaultValue { get; }

        /// <summary>Whether it may be given more than once.</summary>
        public abstract bool IsRepeatable { get; }

        /// <summary>Reads a value.</summary>
        /// <exception cref="UsageException">
        /// Malformed or out of range; the message names the option and the text.
        /// </exception>
        public abstract object ParseValue(string text);

        internal abstract object JoinValues(object before, object value);

        /// <summary>The flag.</summary>
        public override string ToString() => Flag;
    }

    /// <summary>An option with values of type <typeparamref name="T"/>.</summary>
    public sealed class Option<T> : Option
    {
        readonly Func<string, T> _read;

        /// <param name="name">Without dashes.</param>
        /// <param name="valueName">Placeholder of the value in the help.</param>
        /// <param name="read">Reads the value; throws <see cref="FormatException"/> that says what it must be.</param>
        internal Option(string name, string valueName, Func<string, T> read) : base(name, valueName) => _read = read;

        /// <summary>
        /// Joins the values of a repeatable option; null for other options.
        /// </summary>
        internal Func<T, T, T> Join { get; set; }

        /// <summary>The default value; that of the type if the table has none.</summary>
        public T Default => DefaultText == null ? default : Parse(DefaultText);

        /// <inheritdoc/>
        public override object DefaultValue => Default;

        /// <inheritdoc/>
        public override bool IsRepeatable => Join != null;

        /// <summary>Reads a value.</summary>
        /// <exception cref="UsageException">
        /// Malformed or out of range; the message names the option and the text.
        /// </exception>
        public T Parse(string text) => Parse(text, Flag);

        /// <summary>Reads a value from another place than the command line.</summary>
        /// <param name="where">The place, for messages.</param>
        /// <exception cref="UsageException">
        /// Malformed or out of range; the message names the place and the text.
        /// </exception>
        public T Parse(string text, string where) => Values.Parse(_read, text, where);

        /// <inheritdoc/>
        public override object ParseValue(string text) => Parse(text);

        internal override object JoinValues(object before, object value) => Join((T)before, (T)value);
    }
}
