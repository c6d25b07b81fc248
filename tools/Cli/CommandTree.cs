using System;
using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;
using System.CommandLine.Parsing;
using System.Linq;

namespace Glint.Cli;

/// <summary>
/// The parser: a System.CommandLine tree built from the command tables of Glint.Editor, which also validate the
/// values.
/// </summary>
sealed class CommandTree
{
    // The tables' parser gets every value, surplus ones included, so that both hosts give the same messages.
    static readonly ArgumentArity Any = ArgumentArity.ZeroOrMore;

    readonly Terminal _terminal;
    readonly Func<Editor.CommandLine, int> _execute;
    readonly RootCommand _root = new(Editor.Commands.Summary);
    readonly Dictionary<Command, Editor.Command> _commands = [];

    public CommandTree(Terminal terminal, Func<Editor.CommandLine, int> execute)
    {
        _terminal = terminal;
        _execute = execute;
        foreach (var command in Editor.Commands.All)
            _root.Add(Build(command));
        _root.Options.OfType<HelpOption>().Single().Action = new Print(Help);
        _root.Options.OfType<VersionOption>().Single().Action = new Print(_ => Core.GlintVersion.Text + "\n");
    }

    /// <summary>Parses the arguments and runs the command.</summary>
    /// <param name="arguments">The process's arguments.</param>
    /// <param name="onCommand">Called with the command before its options are checked.</param>
    /// <returns>The exit code.</returns>
    /// <exception cref="Core.UsageException">The first error of the command line.</exception>
    public int Invoke(string[] arguments, Action<Editor.Command> onCommand)
    {
        // The first word is checked here because the library would accept a command after an unknown word.
        if (arguments.Length > 0 && !arguments[0].StartsWith('-')
            && Editor.Commands.All.All(command => command.Name != arguments[0]))
            throw NoCommand(arguments[0]);
        var parsed = _root.Parse(arguments,
            new ParserConfiguration { EnablePosixBundling = false, ResponseFileTokenReplacer = null });
        if (parsed.Action is not (null or ParseErrorAction))
            return parsed.Invoke(new InvocationConfiguration
            {
                Output = _terminal.Out, Error = _terminal.Error, EnableDefaultExceptionHandler = false
            });
        if (!_commands.TryGetValue(parsed.CommandResult.Command, out var command))
            throw NoCommand(parsed.UnmatchedTokens.FirstOrDefault());
        onCommand(command);
        return _execute(Read(command, parsed, arguments));
    }

    Command Build(Editor.Command command)
    {
        var built = new Command(command.Name, command.Summary);
        if (command.Inputs != Editor.InputKind.None)
            built.Add(new Argument<string[]>(
                command.InputName)
            { Description = Editor.Commands.InputHelpOf(command), Arity = Any });
        foreach (var option in command.Options)
            built.Add(new Option<string[]>(option.Flag)
            {
                Description = option.Help, HelpName = option.ValueName,
                Arity = option.IsSwitch ? ArgumentArity.Zero : Any
            });
        _commands.Add(built, command);
        return built;
    }

    static Editor.CommandLine Read(Editor.Command command, ParseResult parsed, string[] raw)
    {
        var options = new List<KeyValuePair<string, string>>();
        foreach (var result in parsed.CommandResult.Children.OfType<OptionResult>().Where(result => !result.Implicit))
        {
            // The library parses the text after a switch's "=" as an argument.
            if (command.Options.Any(option => option.IsSwitch && option.Flag == result.Option.Name))
                options.AddRange(raw.Where(word => word.StartsWith(result.Option.Name + "=", StringComparison.Ordinal))
                    .Select(word => Pair(result.Option.Name, word[(word.IndexOf('=') + 1)..])));
            // The library takes the next word as the value of "--name=".
            if (raw.Contains(result.Option.Name + "="))
                options.Add(Pair(result.Option.Name, ""));
            // A word that begins with "--" is a misspelt option, not a value; --name=--value is a value.
            options.AddRange(result.Tokens.Select(token => Pair(result.Option.Name,
                token.Value.StartsWith("--", StringComparison.Ordinal) && raw.Contains(token.Value) ? null : token.Value)));
            options.AddRange(Enumerable.Repeat(Pair(result.Option.Name, null),
                Math.Max(0, result.IdentifierTokenCount - result.Tokens.Count)));
        }

        // Unknown options are among the arguments. A word after "--" is always an argument.
        var words = parsed.CommandResult.Children.OfType<ArgumentResult>().SelectMany(result => result.Tokens)
            .Select(token => token.Value)
            .Concat(parsed.UnmatchedTokens).ToArray();
        int literal = raw.Reverse().TakeWhile(word => word != "--").Count();
        var free = words.SkipLast(literal < raw.Length ? literal : 0).ToArray();
        options.AddRange(free.Where(Editor.CommandLine.LooksLikeOption).Select(word => Pair(word.Split('=')[0], null)));
        return Editor.CommandLine.Create(command,
            [.. free.Where(word => !Editor.CommandLine.LooksLikeOption(word)), .. words.Skip(free.Length)], options);
    }

    static KeyValuePair<string, string> Pair(string flag, string value) => KeyValuePair.Create(flag, value);

    static Core.UsageException NoCommand(string word)
    {
        var names = Editor.Commands.All.Select(command => command.Name).ToArray();
        string list = string.Join(", ", names);
        if (word == null)
            return new Core.UsageException($"a command is missing: {list}");
        if (word == "help")
            return new Core.UsageException("\"help\": no such command: give --help, or NAME --help for one of " + list);
        string nearest = Editor.Spelling.Nearest(word, names);
        return new Core.UsageException($"\"{word}\": no such command: "
            + $"{(nearest == null ? "the commands are " + list : $"did you mean {nearest}?")}");
    }

    // Help with groups and examples, which the library's own help lacks.
    string Help(ParseResult parsed) => _commands.TryGetValue(parsed.CommandResult.Command, out var command)
        ? HelpText.Of(command, _terminal.Width)
        : HelpText.Overview(_terminal.Width);

    /// <summary>Writes a text; the rest of the command line does not matter.</summary>
    sealed class Print(Func<ParseResult, string> text) : SynchronousCommandLineAction
    {
        public override bool ClearsParseErrors => true;

        public override int Invoke(ParseResult parsed)
        {
            parsed.InvocationConfiguration.Output.Write(text(parsed));
            return 0;
        }
    }
}
