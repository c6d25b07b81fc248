using System;
using System.Globalization;

namespace Glint.Tests
{
    /// <summary>
    /// A current culture with numbers and dates unlike the invariant ones: decimal comma, other signs. It is built
    /// here, since a system may have no cultures.
    /// </summary>
    sealed class ForeignCulture : IDisposable
    {
        readonly CultureInfo _before = CultureInfo.CurrentCulture;

        public ForeignCulture()
        {
            var culture = (CultureInfo)CultureInfo.InvariantCulture.Clone();
            culture.NumberFormat.NumberDecimalSeparator = ",";
            culture.NumberFormat.NumberGroupSeparator = ".";
            culture.NumberFormat.NegativeSign = "~";
            culture.NumberFormat.PositiveSign = "&";
            culture.NumberFormat.NaNSymbol = "1";
            culture.DateTimeFormat.TimeSeparator = ".";
            culture.DateTimeFormat.DateSeparator = ".";
            CultureInfo.CurrentCulture = culture;
        }

        public void Dispose() => CultureInfo.CurrentCulture = _before;
    }
}
