using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Glint.Editor;

namespace Glint.Cli;

/// <summary>
/// Shell script that completes glint's command lines, generated from the tables of commands and options.
/// </summary>
/// <param name="shell">One of <see cref="Commands.Shells"/>.</param>
sealed class CompletionScript(string shell)
{
    static readonly string[] s_meshes = ["unity", "obj", "stl"];

    readonly StringBuilder _text = new();

    public string Write()
    {
        Line($"# Completion of glint for {shell}, made by: glint completion {shell}");
        switch (shell)
        {
            case "bash": WriteBash(); break;
            case "zsh": WriteZsh(); break;
            default: WriteFish(); break;
        }
        return _text.ToString();
    }

    static bool TakesFolder(Option option) => option.ValueName == "DIR";

    static bool TakesFile(Option option) => option.ValueName.Trim('[', ']') == "FILE";

    // A value of a known form but unknown content: the shell must not offer files.
    static bool IsFree(Option option) => !option.IsSwitch && option.ImpliedText == null && option.Choices.Count == 0
        && !TakesFolder(option) && !TakesFile(option);

    void WriteBash()
    {
        Line("_glint() {");
        Line("    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]}");
        Line("    COMPREPLY=()");
        Line("    # bash makes three words of --name=value");
        Line("    if [[ $word == \"=\" ]]; then word=; elif [[ $before == \"=\" ]]; "
            + "then before=${COMP_WORDS[COMP_CWORD-2]}; fi");
        Line("    if (( COMP_CWORD == 1 )); then");
        Line($"        COMPREPLY=($(compgen -W \"{Names(Commands.All)} --help --version\" -- \"$word\"))");
        Line("        return");
        Line("    fi");
        Line("    case $command:$before in");
        foreach (var command in Commands.All)
        {
            Cases(command, option => option.Choices.Count > 0,
                option => $"COMPREPLY=($(compgen -W \"{string.Join(' ', option.Choices)}\" -- \"$word\")); return");
            Cases(command, TakesFolder, _ => "_glint_files -d; return");
            Cases(command, TakesFile, _ => "_glint_files -f; return");
            Cases(command, IsFree, _ => "return");
        }
        Line("    esac");
        Line("    case $command in");
        foreach (var command in Commands.All)
            Line($"        {command.Name}) [[ $word == -* ]] && COMPREPLY=($(compgen -W \"{Flags(command)}\" -- "
                + $"\"$word\")) || {BashInput(command)} ;;");
        Line("    esac");
        Line("}");
        Line("_glint_files() {");
        Line("    compopt -o filenames 2>/dev/null");
        Line("    mapfile -t COMPREPLY < <(compgen \"$@\" -- \"$word\")");
        Line("}");
        Line("_glint_meshes() {");
        Line("    compopt -o filenames 2>/dev/null");
        Line("    mapfile -t COMPREPLY < <(compgen -d -- \"$word\"; "
            + $"{string.Join("; ", s_meshes.Select(end => $"compgen -f -X '!*.{end}' -- \"$word\""))})");
        Line("}");
        Line("complete -F _glint glint");

        // One line of a case for the options with the same completion.
        void Cases(Command command, Func<Option, bool> which, Func<Option, string> answer)
        {
            foreach (var group in command.Options.Where(which).GroupBy(answer))
                Line($"        {string.Join('|', group.Select(option => $"{command.Name}:{option.Flag}"))}) "
                    + $"{group.Key} ;;");
        }
    }

    static string BashInput(Command command) => command.Inputs switch
    {
        InputKind.None => ":",
        InputKind.Shell => $"COMPREPLY=($(compgen -W \"{string.Join(' ', Commands.Shells)}\" -- \"$word\"))",
        InputKind.Folders or InputKind.Results => "_glint_files -d",
        _ => "_glint_meshes"
    };

    void WriteZsh()
    {
        Line("#compdef glint");
        Line("_glint() {");
        Line("    local curcontext=$curcontext state line");
        Line("    if (( CURRENT == 2 )); then");
        Line("        local -a "
            + $"commands=({string.Join(' ', Commands.All.Select(command => Quoted($"{command.Name}:{command.Summary}")))})");
        Line("        _describe command commands");
        Line("        return");
        Line("    fi");
        Line("    local command=$words[2]");
        Line("    words=(glint \"${(@)words[3,-1]}\")");
        Line("    (( CURRENT-- ))");
        Line("    case $command in");
        foreach (var command in Commands.All)
        {
            var specs = command.Options.Select(option => $"{(option.IsRepeatable ? "*" : "")}"
                + $"{option.Flag}[{Bracketed(Sentence(option.Help))}]{ZshValue(option)}")
                .Append("--help[Help.]").ToList();
            if (command.Inputs != InputKind.None)
                specs.Add(command.Inputs switch
                {
                    InputKind.Shell => $"1:shell:({string.Join(' ', Commands.Shells)})",
                    InputKind.Folders => "*:folder:_files -/",
                    InputKind.Results => "1:folder:_files -/",
                    _ => $"1:scene or mesh:_files -g \"*.({string.Join('|', s_meshes)})\""
                });
            Line($"        {command.Name}) _arguments {string.Join(' ', specs.Select(Quoted))} ;;");
        }
        Line("    esac");
        Line("}");
        Line("if [[ $zsh_eval_context[-1] == loadautofunc ]]; then _glint \"$@\"; else compdef _glint glint; fi");
    }

    static string ZshValue(Option option)
    {
        if (option.IsSwitch)
            return "";
        string action = option.Choices.Count > 0 ? $"({string.Join(' ', option.Choices)})"
            : TakesFolder(option) ? "_files -/"
            : TakesFile(option) ? "_files"
            : " ";
        return $":{option.ValueName.Trim('[', ']')}:{action}".Insert(0, option.ImpliedText == null ? "" : ":");
    }

    void WriteFish()
    {
        Line("complete -c glint -f");
        foreach (var command in Commands.All)
            Line($"complete -c glint -n __fish_use_subcommand -a {command.Name} -d {Fish(command.Summary)}");
        Line("complete -c glint -l help -d Help");
        Line("complete -c glint -n __fish_use_subcommand -l version -d Version");
        foreach (var command in Commands.All)
        {
            string start = $"complete -c glint -n '__fish_seen_subcommand_from {command.Name}'";
            foreach (var option in command.Options)
                Line($"{start} -l {option.Name}{FishValue(option)} -d {Fish(Sentence(option.Help))}");
            if (command.Inputs != InputKind.None)
                Line(start + command.Inputs switch
                {
                    InputKind.Shell => $" -a '{string.Join(' ', Commands.Shells)}'",
                    InputKind.Folders or InputKind.Results => " -a '(__fish_complete_directories)'",
                    _ => $" -k -a '({string.Join("; ", s_meshes.Select(end => $"__fish_complete_suffix .{end}"))})'"
                });
        }
    }

    static string FishValue(Option option) =>
        option.IsSwitch ? ""
            : option.Choices.Count > 0 ? $" -x -a '{string.Join(' ', option.Choices)}'"
            : TakesFolder(option) ? " -x -a '(__fish_complete_directories)'"
            : TakesFile(option) ? option.ImpliedText == null ? " -r -F"
            : " -F"
            : " -x";

    static string Names(IEnumerable<Command> commands) => string.Join(' ', commands.Select(command => command.Name));

    static string Flags(Command command) =>
        string.Join(' ', command.Options.Select(option => option.Flag).Append("--help"));

    // The first sentence. A full stop within a name or number has no space after it.
    static string Sentence(string help) =>
        help.IndexOf(". ", StringComparison.Ordinal) is var end && end > 0 ? help[..(end + 1)] : help;

    static string Bracketed(string text) => text.Replace("[", "\\[").Replace("]", "\\]").Replace(":", "\\:");

    static string Quoted(string text) => "'" + text.Replace("'", "'\\''") + "'";

    static string Fish(string text) => "'" + text.Replace("\\", "\\\\").Replace("'", "\\'") + "'";

    void Line(string text) => _text.Append(text).Append('\n');
}
