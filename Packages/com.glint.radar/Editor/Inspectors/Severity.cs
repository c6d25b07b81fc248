namespace Glint.Editor
{
    /// <summary>How bad a finding is.</summary>
    enum Severity
    {
        /// <summary>It can be traced, and the result may mislead.</summary>
        Warning,

        /// <summary>It cannot be traced.</summary>
        Error,
    }
}
