using System;
using System.Collections.Generic;
using Glint.Core;
using Object = UnityEngine.Object;

namespace Glint.Editor
{
    /// <summary>A finding of a check.</summary>
    sealed class Finding
    {
        public Finding(Severity severity, string text, Fix fix = null, Object where = null) =>
            (Severity, Text, Fix, Where) = (severity, text, fix, where);

        public Severity Severity { get; }

        /// <summary>One line: object, value, remedy.</summary>
        public string Text { get; }

        /// <summary>The fix of a button; null if there is none.</summary>
        public Fix Fix { get; }

        /// <summary>The object of the finding, if it is not the one checked; else null.</summary>
        public Object Where { get; }

        /// <summary>The refusal of a check as a finding; null if it refuses nothing.</summary>
        /// <param name="check">Throws a GlintException.</param>
        /// <param name="fix">Corrects the refused value; null for none.</param>
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

        /// <summary>Adds the refusal of a check to some findings.</summary>
        /// <returns>Whether it refuses nothing.</returns>
        /// <inheritdoc cref="Of"/>
        public static bool Add(List<Finding> findings, Action check, Func<Fix> fix = null)
        {
            var finding = Of(check, fix);
            if (finding != null)
                findings.Add(finding);
            return finding == null;
        }

        public override string ToString() => $"{Severity}: {Text}";
    }

    /// <summary>Severity of a finding.</summary>
    enum Severity
    {
        /// <summary>A trace is possible, but the result may mislead.</summary>
        Warning,

        /// <summary>A trace is impossible.</summary>
        Error,
    }
}
