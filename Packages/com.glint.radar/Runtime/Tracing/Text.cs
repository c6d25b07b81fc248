using System;

namespace Glint
{
    /// <summary>Figures in messages.</summary>
    public static class Text
    {
        /// <summary>"1234 MiB", for messages.</summary>
        public static string Mebibytes(double bytes) => FormattableString.Invariant($"{bytes / 1048576:0.#} MiB");
    }
}
