using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>
    /// A validated command line: command, input and options. No file has been opened yet.
    /// </summary>
    public sealed class CommandLine
    {
        /// <summary>Separates Unity's own arguments from those of the command.</summary>
        public const string UnityMarker = "--glint";

        readonly Dictionary<Option, object> _values = new Dictionary<Option, object>();

        CommandLine(Command command) => Command = command;

        /// <summary>The command.</summary>
        public Command Command { get; }

        /// <summary>The scene, mesh file, results folder or shell as given; null if there is none.</summary>
        public string Input { get; private set; }

        /// <summary>The folders as given, for a command that takes folders.</summary>
        public IReadOnlyList<string> Folders { get; private set; } = Array.Empty<string>();

        /// <summary>Kind of <see cref="Input"/>, from the command or the file's extension.</summary>
        public InputKind InputKind { get; private set; }

        /// <summary>
        /// The command's name, the input and the options as given. From the arguments after the name <see
        /// cref="Parse"/> gives the same line.
        /// </summary>
        public IReadOnlyList<string> Arguments { get; private set; }

        /// <summary>Value of an option, or its default.</summary>
        public T Get<T>(Option<T> option) => _values.TryGetValue(option, out var value) ? (T)value : option.Default;

        /// <summary>The same where the type is not known.</summary>
        internal object ValueOf(Option option) =>
            _values.TryGetValue(option, out var value) ? value : option.DefaultValue;

        /// <summary>Whether an option was given.</summary>
        public bool IsGiven(Option option) => _values.ContainsKey(option);

        /// <summary>
        /// Reads the arguments of a command in Unity's batch mode: all after <see cref="UnityMarker"/>.
        /// </summary>
        /// <exception cref="UsageException">The first error.</exception>
        public static CommandLine FromUnity(Command command, IReadOnlyList<string> processArguments)
        {
            var own = processArguments.SkipWhile(argument => argument != UnityMarker).ToArray();
            if (own.Length == 0)
                throw new UsageException($"{UnityMarker} is missing: put the arguments of {command.Name} after it, "
                    + "at the end of Unity's command line");
            var line = Parse(command, own.Skip(1).ToArray());
            foreach (var option in line.Command.Options)
                if (option.UnityRemedy != null && line.IsGiven(option))
                    throw new UsageException($"{option.Flag}: {option.UnityRemedy}");
            return line;
        }

        /// <summary>
        /// Reads the arguments of a command: INPUT and options in any order,
        /// <c>--name value</c> or <c>--name=value</c>, after <c>--</c> no options.
        /// A value may begin with '-', as negative numbers do, but not with "--".
        /// </summary>
        /// <exception cref="UsageException">The first error.</exception>
        public static CommandLine Parse(Command command, IReadOnlyList<string> arguments)
        {
            var inputs = new List<string>();
            var options = new List<KeyValuePair<string, string>>();
            for (int i = 0; i < arguments.Count; i++)
            {
                string argument = arguments[i];
                if (argument == "--")
                {
                    inputs.AddRange(arguments.Skip(i + 1));
                    break;
                }
                int equals = argument.IndexOf('=');
                if (!LooksLikeOption(argument))
                    inputs.Add(argument);
                else if (equals >= 0)
                    options.Add(Pair(argument.Substring(0, equals), argument.Substring(equals + 1)));
                else if (Find(command, argument)?.IsSwitch == true)
                    options.Add(Pair(argument, null));
                else if (i + 1 < arguments.Count && !arguments[i + 1].StartsWith("--", StringComparison.Ordinal)
                    && Find(command, argument) != null)
                    options.Add(Pair(argument, arguments[++i]));
                else
                    options.Add(Pair(argument, null));
            }
            return Create(command, inputs, options);
        }

        /// <summary>
        /// Validates the output of a parser. Both hosts use it, so that their error messages are the same.
        /// </summary>
        /// <param name="command">The command.</param>
        /// <param name="inputs">The arguments that are not options.</param>
        /// <param name="options">Options as written, with dashes, and their values; null for a missing value.</param>
        /// <exception cref="UsageException">The first error.</exception>
        public static CommandLine Create(Command command, IReadOnlyList<string> inputs,
            IReadOnlyList<KeyValuePair<string, string>> options)
        {
            var line = new CommandLine(command);
            foreach (var given in options)
                line.Add(given.Key, given.Value);
            line.SetInput(inputs);
            line.CheckOptionsAgainstInput();
            line.CheckOptionsAgainstEachOther();
            line.Arguments = new[] { command.Name }
                .Concat(options.Select(option => option.Value == null ? option.Key : $"{option.Key}={option.Value}"))
                .Concat(inputs.Count == 0 ? inputs : inputs.Prepend("--")).ToArray();
            return line;
        }

        /// <summary>
        /// Whether an argument has the form of an option: a dash followed by a letter or dash. Negative numbers do not.
        /// </summary>
        public static bool LooksLikeOption(string argument) =>
            argument.Length > 1 && argument[0] == '-' && (argument[1] == '-' || char.IsLetter(argument[1]));

        void Add(string flag, string text)
        {
            var option = Find(Command, flag);
            if (option == null)
                throw new UsageException($"{flag}: {Command.Name} has no such "
                    + $"option{Suggest(flag, Command.Options.Select(known => known.Flag))}");
            bool isGiven = _values.TryGetValue(option, out var before);
            if (isGiven && !option.IsRepeatable)
                throw new UsageException($"{flag}: given twice");
            text ??= option.ImpliedText;
            if (text == null)
                throw new UsageException($"{flag}: needs a value: {flag} {option.ValueName}");
            var value = option.ParseValue(text);
            _values[option] = isGiven ? option.JoinValues(before, value) : value;
        }

        void SetInput(IReadOnlyList<string> inputs)
        {
            if (Command.Inputs == InputKind.Folders)
            {
                SetFolders(inputs);
                return;
            }
            int expected = Command.Inputs == InputKind.None ? 0 : 1;
            if (inputs.Count > expected)
                throw new UsageException($"{Values.Shown(inputs[expected])}: one argument too many: "
                    + $"{(expected == 0 ? Command.Name + " takes none" : $"{Command.InputName.Trim('[', ']')} is {Values.Shown(inputs[0])} already")} "
                    + "(put names with blanks in quotes)");
            if (expected == 0)
                return;
            if (inputs.Count == 0 && Command.HasBuiltIn)
            {
                InputKind = InputKind.BuiltIn;
                return;
            }
            if (inputs.Count == 0)
                throw new UsageException($"{Command.Name}: {Command.InputName} is missing: give {WhatInputIs}");
            if (string.IsNullOrWhiteSpace(inputs[0]))
                throw new UsageException($"{Command.Name}: {Command.InputName.Trim('[', ']')} is empty: "
                    + $"give {WhatInputIs}");
            Input = inputs[0];
            if (Command.Inputs == InputKind.Shell && !Commands.Shells.Contains(Input))
                throw new UsageException($"{Command.Name}: {Values.Shown(Input)}: no such shell: give {WhatInputIs}");
            InputKind = Command.Inputs == InputKind.Results
                || Command.Inputs == InputKind.Shell ? Command.Inputs : KindOf(Input);
            if ((Command.Inputs & InputKind) == 0)
                throw new UsageException($"{Values.Shown(Input)}: {Command.Name} does not take such a file: "
                    + $"give {WhatInputIs}");
        }

        string WhatInputIs => Command.Inputs == InputKind.Results ? "a folder with results"
            : Command.Inputs == InputKind.Shell ? string.Join(", ", Commands.Shells)
            : Command.Inputs == InputKind.Scene ? "a scene (.unity)"
            : "a scene (.unity) or a mesh file (.obj, .stl)";

        void SetFolders(IReadOnlyList<string> folders)
        {
            if (folders.Count == 0)
                throw new UsageException($"{Command.Name}: DIR is missing: give the results folders of all parts");
            if (folders.Any(string.IsNullOrWhiteSpace))
                throw new UsageException($"{Command.Name}: a DIR is empty: give the name of a folder");
            var seen = new HashSet<string>();
            string twice = folders.FirstOrDefault(folder => !seen.Add(ResultsMerge.FullPathOf(folder)));
            if (twice != null)
                throw new UsageException($"{Command.Name}: {Values.Shown(twice)}: given twice: give each part once");
            Folders = folders;
        }

        void CheckOptionsAgainstInput()
        {
            foreach (var option in Command.Options)
                if (IsGiven(option) && InputKind != InputKind.None && (option.Inputs & InputKind) == 0)
                    throw new UsageException($"{option.Flag}: {option.Refusal}");
            foreach (var option in Command.Required)
                if (!IsGiven(option) && (InputKind == InputKind.None || (option.Inputs & InputKind) != 0)
                    && (option.Needs.Count == 0 || option.Needs.Any(IsGiven)))
                    throw new UsageException($"{option.Flag} is missing: "
                        + $"{Command.Name} needs {option.Flag} {option.ValueName}");
            if (Command.OneOf.Count > 0 && !Command.OneOf.Any(IsGiven) && !Command.Required.Any(IsGiven))
                throw new UsageException($"{Command.Name}: nothing to step through: "
                    + $"give {Either(Command.OneOf.Where(option => (option.Inputs & InputKind) != 0))}");
        }

        // "--angles ANGLES, --grazing LIST or --distance LIST"
        static string Either(IEnumerable<Option> options)
        {
            var forms = options.Select(option => $"{option.Flag} {option.ValueName}").ToArray();
            return forms.Length == 1
                ? forms[0]
                : $"{string.Join(", ", forms.Take(forms.Length - 1))} or {forms[forms.Length - 1]}";
        }

        void CheckOptionsAgainstEachOther()
        {
            foreach (var option in Command.Options.Where(IsGiven))
            {
                if (option.Needs.Count > 0 && !option.Needs.Any(IsGiven))
                    throw new UsageException($"{option.Flag}: needs {Either(option.Needs)}");
                foreach (var (excluded, reason) in option.Excludes)
                    if (IsGiven(excluded))
                        throw new UsageException($"{option.Flag}: not with {excluded.Flag}: {reason}");
            }
        }

        static InputKind KindOf(string input)
        {
            switch (Path.GetExtension(input).ToLowerInvariant())
            {
                case ".unity": return InputKind.Scene;
                case ".obj":
                case ".stl": return InputKind.MeshFile;
                default:
                    throw new UsageException($"{Values.Shown(input)}: "
                    + "neither a scene (.unity) nor a mesh file (.obj, .stl)");
            }
        }

        static Option Find(Command command, string flag) =>
            command.Options.FirstOrDefault(option => option.Flag == flag);

        static string Suggest(string word, IEnumerable<string> names)
        {
            var nearest = Spelling.Nearest(word, names);
            return nearest == null ? "" : $"; did you mean {nearest}?";
        }

        static KeyValuePair<string, string> Pair(string flag, string text) =>
            new KeyValuePair<string, string>(flag, text);
    }

    /// <summary>Suggests the intended name for a misspelt one.</summary>
    public static class Spelling
    {
        /// <summary>The known name nearest to a word; null if none is near.</summary>
        public static string Nearest(string word, IEnumerable<string> names)
        {
            var near = names.Select(name => (name, distance: name.StartsWith(word, StringComparison.Ordinal)
                    && word.Length > 1 ? 0 : Distance(word, name)))
                .OrderBy(pair => pair.distance).FirstOrDefault();
            return near.name != null && near.distance <= Math.Max(1, word.Length / 3) ? near.name : null;
        }

        // Levenshtein distance, one row of the table at a time.
        static int Distance(string from, string to)
        {
            var row = Enumerable.Range(0, to.Length + 1).ToArray();
            for (int i = 1; i <= from.Length; i++)
            {
                int diagonal = row[0];
                row[0] = i;
                for (int j = 1; j <= to.Length; j++)
                {
                    int replaced = diagonal + (from[i - 1] == to[j - 1] ? 0 : 1);
                    diagonal = row[j];
                    row[j] = Math.Min(replaced, Math.Min(row[j], row[j - 1]) + 1);
                }
            }
            return row[to.Length];
        }
    }
}
