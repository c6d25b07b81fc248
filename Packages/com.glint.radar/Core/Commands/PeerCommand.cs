using System;

namespace Glint.Core
{
    /// <summary>A program that a benchmark times in alternation with Glint.</summary>
    public readonly struct PeerCommand
    {
        PeerCommand(string name, string command)
        {
            Name = name;
            Command = command;
        }

        /// <summary>Name in the tables.</summary>
        public string Name { get; }

        /// <summary>Its command line, for the shell.</summary>
        public string Command { get; }

        /// <summary>Reads NAME=COMMAND.</summary>
        /// <exception cref="FormatException">Name or command is missing.</exception>
        public static PeerCommand Parse(string text)
        {
            int equals = text.IndexOf('=');
            string name = equals < 0 ? "" : text.Substring(0, equals).Trim(),
                command = text.Substring(equals + 1).Trim();
            return name.Length > 0 && command.Length > 0
                ? new PeerCommand(name, command)
                : throw new FormatException("must be NAME=COMMAND, such as \"Embree=./embree {scene}\"");
        }
    }
}
