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

        /// <summary>What stands for the value in the help: "NAME".</summary>
        public string ValueName { get; }

        /// <summary>One or two sentences for the user, units included.</summary>
        public string Help { get; internal set; }

        /// <summary>Range of the value in words; null when any will do.</summary>
        public string Range { get; internal set; }

        /// <summary>
        /// Values to offer while a command line is typed; empty when there are too many, or only names of files.
        /// </summary>
        public IReadOnlyList<string> Choices { get; internal set; } = Array.Empty<string>();

        /// <summary>The value when the option is not given, as it would be written; null when there is none.</summary>
        public string DefaultText { get; internal set; }

        /// <summary>
        /// The value when the option is given without one, as it would be written; null when it needs one.
        /// </summary>
        public string ImpliedText { get; internal set; }

        /// <summary>Whether it stands alone, without a value.</summary>
        public bool IsSwitch { get; internal set; }

        /// <summary>Heading of the help under which the option stands.</summary>
        public string Group { get; internal set; }

        /// <summary>The inputs that the option goes with.</summary>
        public InputKind Inputs { get; internal set; } = InputKind.Any;

        /// <summary>Why the option is refused with the other inputs, and what to do instead.</summary>
        public string Refusal { get; internal set; }

        /// <summary>
        /// Options without all of which this one means nothing: one of them must be given with it. Empty for none.
        /// </summary>
        public IReadOnlyList<Option> Needs { get; internal set; } = Array.Empty<Option>();

        /// <summary>Options that cannot be given with this one, each with the reason.</summary>
        public IReadOnlyList<(Option option, string reason)> Excludes { get; internal set; } =
            Array.Empty<(Option, string)>();

        /// <summary>What to use in Unity, which has a way of its own; null for options that both hosts take.</summary>
        public string UnityRemedy { get; internal set; }

        /// <summary>The value of the option when it is not given.</summary>
        public abstract object DefaultValue { get; }

        /// <summary>Whether it may be given more than once.</summary>
        public abstract bool IsRepeatable { get; }

        /// <summary>Reads a value.</summary>
        /// <exception cref="UsageException">
        /// Malformed or out of range; the message names the option and the text.
        /// </exception>
        public abstract object ParseValue(string text);

        internal abstract object JoinValues(object before, object value);

        /// <summary>The option as written.</summary>
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
        /// Makes one value of those of an option that may be given more than once; null for other options.
        /// </summary>
        internal Func<T, T, T> Join { get; set; }

        /// <summary>The value when the option is not given; the type's default when the table has none.</summary>
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

        /// <summary>Reads a value that is written elsewhere than after the option.</summary>
        /// <param name="where">Where, for the message.</param>
        /// <exception cref="UsageException">
        /// Malformed or out of range; the message names the place and the text.
        /// </exception>
        public T Parse(string text, string where) => Values.Parse(_read, text, where);

        /// <inheritdoc/>
        public override object ParseValue(string text) => Parse(text);

        internal override object JoinValues(object before, object value) => Join((T)before, (T)value);
    }
}
