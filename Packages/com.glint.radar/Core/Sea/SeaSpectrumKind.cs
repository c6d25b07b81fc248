namespace Glint.Core
{
    /// <summary>
    /// Distribution of a sea's variance over wavelengths. Wind and fetch set the shape only; the height is a separate
    /// setting.
    /// </summary>
    public enum SeaSpectrumKind
    {
        /// <summary>
        /// Tessendorf's form of the Phillips spectrum (Simulating Ocean Water, 2001, eq. 40): 1/k^4,
        /// cut off above the wave whose speed is the wind's.
        /// </summary>
        Phillips,

        /// <summary>Pierson and Moskowitz 1964: a fully developed sea.</summary>
        PiersonMoskowitz,

        /// <summary>JONSWAP, Hasselmann et al. 1973: a developing sea of limited fetch, with a sharper peak.</summary>
        Jonswap
    }
}
