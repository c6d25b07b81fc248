namespace Glint.Editor
{
    /// <summary>Severity of a finding.</summary>
    enum Severity
    {
        /// <summary>A trace is possible, but the result may mislead.</summary>
        Warning,

        /// <summary>A trace is impossible.</summary>
        Error,
    }
}
