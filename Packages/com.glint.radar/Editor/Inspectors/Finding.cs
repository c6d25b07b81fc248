using System;
using Glint.Core;
using Object = UnityEngine.Object;

namespace Glint.Editor
{
    /// <summary>Something that a check has found.</summary>
    sealed class Finding
    {
        public Finding(Severity severity, string text, Fix fix = null, Object where = null) =>
            (Severity, Text, Fix, Where) = (severity, text, fix, where);

        public Severity Severity { get; }

        /// <summary>One line: object, value, way out.</summary>
        public string Text { get; }

        /// <summary>What a button mends; null where the user must.</summary>
        public Fix Fix { get; }

        /// <summary>The object to look at, where it is not the one checked; else null.</summary>
        public Object Where { get; }

        /// <summary>What a check refuses; null when it finds nothing wrong.</summary>
        /// <param name="check">Throws a GlintException.</param>
        /// <param name="fix">Mends what is refused; null for none.</param>
        public static Finding Of(Action check, Func<Fix> fix = null)
        {
            try
            {
                check();
                return null;
            }
            catch (GlintException problem)
            {
                return new Finding(Severity.Error, problem.Message, fix?.Invoke());
            }
        }

        public override string ToString() => $"{Severity}: {Text}";
    }

    /// <summary>How bad a finding is.</summary>
    enum Severity
    {
        /// <summary>It can be traced, and the result may mislead.</summary>
        Warning,

        /// <summary>It cannot be traced.</summary>
        Error,
    }
}
