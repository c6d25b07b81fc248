using Object = UnityEngine.Object;

namespace Glint.Editor
{
    /// <summary>A finding of a check.</summary>
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

        /// <summary>One line: object, value, remedy.</summary>
        public string Text { get; }

        /// <summary>The fix of a button; null if there is none.</summary>
        public Fix Fix { get; }

        /// <summary>The object of the finding, if it is not the one checked; else null.</summary>
        public Object Where { get; }

        public override string ToString() => $"{Severity}: {Text}";
    }
}
