using System;

namespace Glint.Core
{
    /// <summary>
    /// A failure the user can mend: the message is one line that names the object, the value and the way out.
    /// </summary>
    public class GlintException : Exception
    {
        /// <summary>A failure with its message.</summary>
        /// <param name="message">One line: the object, the value, the way out.</param>
        public GlintException(string message) : base(message) { }

        /// <summary>A failure that another one brought about.</summary>
        /// <param name="message">One line: the object, the value, the way out.</param>
        /// <param name="cause">For who looks for the reason; not shown to the user.</param>
        public GlintException(string message, Exception cause) : base(message, cause) { }

        /// <summary>Exit code of the command: 1 for what was found on opening files, scene or device.</summary>
        public virtual int ExitCode => 1;
    }

    /// <summary>
    /// A wrong call: unknown option, missing argument, value malformed or out of its range.
    /// Known before any file is opened.
    /// </summary>
    public sealed class UsageException : GlintException
    {
        /// <summary>A wrong call.</summary>
        /// <param name="message">One line: the option or argument, its value, the range or form it must have.</param>
        public UsageException(string message) : base(message) { }

        /// <summary>Exit code of the command: 2.</summary>
        public override int ExitCode => 2;
    }
}
