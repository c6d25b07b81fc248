namespace Glint.Core
{
    /// <summary>
    /// How a sea's variance is spread over wavelengths. The height is asked for apart from it:
    /// wind and fetch decide the shape only.
    /// </summary>
    public enum SeaSpectrumKind
    {
        /// <summary>
        /// Tessendorf's form of the Phillips spectrum (Simulating Ocean Water, 2001, eq. 40): 1/k^4,
        /// cut off above the wave that runs as fast as the wind.
        /// </summary>
        Phillips,

        /// <summary>Pierson and Moskowitz 1964: a fully risen sea.</summary>
        PiersonMoskowitz,

        /// <summary>JONSWAP, Hasselmann et al. 1973: a sea still growing over its fetch, with a sharper peak.</summary>
        Jonswap
    }
}
