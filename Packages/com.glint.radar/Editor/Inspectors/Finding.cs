using Object = UnityEngine.Object;

namespace Glint.Editor
{
    /// <summary>Something that a check has found.</summary>
    sealed class Finding
    {
        public Finding(Severity severity, string text, Fix fix = null, Object where = null)
        {
            Severity = severity;
            Text = text;
            Fix = fix;
            Where = where;
        }

        public Severity Severity { get; }

        /// <summary>One line: object, value, way out.</summary>
        public string Text { get; }

        /// <summary>What a button mends; null where the user must.</summary>
        public Fix Fix { get; }

        /// <summary>The object to look at, where it is not the one checked; else null.</summary>
        public Object Where { get; }

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
