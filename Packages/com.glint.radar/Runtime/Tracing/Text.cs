using System;

namespace Glint
{
    static class Text
    {
        /// <summary>"1234 MiB", for messages.</summary>
        public static string Mebibytes(double bytes) => FormattableString.Invariant($"{bytes / 1048576:0.#} MiB");
    }
}
