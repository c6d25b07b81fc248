using System;

namespace Glint.Core
{
    /// <summary>A failure the user can mend: the message is one line that names the object, the value and the way out.</summary>
    public class GlintException : Exception
    {
        public GlintException(string message) : base(message) { }

        public GlintException(string message, Exception cause) : base(message, cause) { }

        /// <summary>Exit code of the command: 1 for what was found on opening files, scene or device.</summary>
        public virtual int ExitCode => 1;
    }

    /// <summary>A wrong call: unknown option, missing argument, value malformed or out of its range. Known before any file is opened.</summary>
    public sealed class UsageException : GlintException
    {
        public UsageException(string message) : base(message) { }

        /// <summary>Exit code of the command: 2.</summary>
        public override int ExitCode => 2;
    }
}
