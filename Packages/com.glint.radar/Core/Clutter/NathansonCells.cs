namespace Glint.Core
{
    /// <summary>
    /// Mean reflectivities of the sea: Nathanson, Radar Design Principles, second edition (1991), as tabulated by
    /// Gregers-Hansen and Mital, NRL/MR/5310-12-9346 (2012; approved for public release, distribution unlimited).
    /// Figures only.
    /// </summary>
    static class NathansonCells
    {
        /// <summary>In place of a measurement.</summary>
        public const sbyte None = 0;

        /// <summary>Frequencies of the columns, GHz.</summary>
        public static readonly double[] Gigahertz = { 0.5, 1.25, 3, 5.6, 9.3, 17, 35 };

        /// <summary>Grazing angles of the rows of a sea state, degrees.</summary>
        public static readonly double[] Grazing = { 0.1, 0.3, 1, 3, 10, 30, 60 };

        /// <summary>Sea states from 0.</summary>
        public const int SeaStates = 7;

        /// <summary>Decibels of HH, by sea state, grazing angle and frequency.</summary>
        public static readonly sbyte[] Horizontal =
        {
            // sea state 0
            None, None, -90, -87, None, None, None,
            None, None, -83, -79, -74, None, None,
            -86, -80, -75, -70, -60, -60, -60,
            -75, -72, -68, -63, -58, None, -53,
            None, -60, None, -44, -56, None, None,
            None, -50, -50, -50, -48, -45, None,
            -32, -32, -32, -27, -25, -22, -26,
            // sea state 1
            None, None, -80, -75, -71, None, None,
            None, None, -74, -68, -66, -58, None,
            -84, -73, -66, -56, -51, -48, -48,
            -70, -62, -59, -54, -50, -45, -43,
            None, -56, None, -53, -51, None, None,
            None, -46, None, -48, -44, -38, None,
            -22, -24, -25, -26, -24, -20, None,
            // sea state 2
            -95, -90, -75, -67, -59, -48, None,
            -78, None, -66, -60, -56, -53, None,
            -82, -65, -55, -48, -46, -41, -38,
            -66, -59, -53, -48, -43, -38, -40,
            -54, -53, -51, -48, -43, -37, -36,
            -42, -41, -40, -42, -38, -35, -35,
            -22, -21, -21, -22, -23, -18, None,
            // sea state 3
            -90, -82, -68, -69, -53, None, None,
            None, -68, -60, -50, -46, -42, None,
            -73, -60, -48, -43, -40, -37, -36,
            -61, -55, -46, -42, -39, -35, -37,
            -50, -48, -46, -40, -37, -32, -31,
            -40, -39, -38, -37, -34, -28, -29,
            -21, -20, -20, -20, -21, -16, -16,
            // sea state 4
            None, -74, -63, -60, -48, None, None,
            None, None, -55, None, -42, -39, None,
            -63, -56, -45, -39, -36, -34, -34,
            -54, -48, -41, -38, -35, -32, -32,
            -48, -45, -40, -36, -34, -29, -29,
            -38, -37, -37, -35, -29, -21, -21,
            -21, -18, -17, -16, -15, -12, -12,
            // sea state 5
            None, -70, -63, -58, -42, None, None,
            None, -64, -52, -44, -39, -38, None,
            -60, -50, -42, -36, -34, -34, None,
            -53, -46, -40, -36, -33, -30, None,
            -46, -43, -38, -36, -30, -26, -27,
            -35, -34, -32, -30, -26, -18, -20,
            -21, -18, -17, -17, -14, -10, None,
            // sea state 6
            None, None, None, None, None, None, None,
            None, None, -46, None, -34, -37, None,
            None, None, -41, None, -32, -32, None,
            None, None, -37, None, -30, -28, None,
            -44, -40, -37, -35, -27, -24, None,
            -33, -32, -30, -29, -21, -16, None,
            -20, -19, -17, -16, -12, -10, None
        };

        /// <summary>The same of VV.</summary>
        public static readonly sbyte[] Vertical =
        {
            // sea state 0
            None, None, None, None, None, None, None,
            None, -83, None, None, None, -63, -55,
            None, -68, None, None, -60, -60, -60,
            None, None, None, -60, -56, -50, -48,
            None, -45, None, -44, -47, -45, -44,
            None, -42, -42, -42, -37, -33, None,
            -32, -33, -34, -26, -23, -22, None,
            // sea state 1
            None, None, -80, -72, -65, None, None,
            None, -78, -64, -60, -58, -54, -46,
            -70, -65, -56, -53, -50, -50, -48,
            -60, -53, -52, -49, -45, -41, -41,
            -38, -39, -40, -41, -42, -40, -38,
            -38, -38, -40, -42, -36, -31, -35,
            -23, -22, -24, -24, -24, -20, -24,
            // sea state 2
            -90, -87, -75, -67, -56, None, None,
            -80, -73, -62, -55, -52, -52, -43,
            -63, -58, -53, -47, -44, -42, -40,
            -53, -50, -49, -45, -41, -39, -37,
            -35, -37, -38, -39, -36, -34, -33,
            -30, -31, -32, -34, -32, -26, -30,
            -20, -21, -21, -23, -18, -18, -19,
            // sea state 3
            -88, -82, -75, -60, -51, None, -47,
            -78, -70, -58, -50, -45, -47, -40,
            -58, -54, -48, -43, -39, -37, -34,
            -43, -43, -43, -40, -38, -36, -34,
            -34, -34, -34, -34, -32, -31, -31,
            -28, -30, -29, -28, -26, -23, -23,
            -18, -18, -19, -18, -16, -14, -14,
            // sea state 4
            -85, -78, -67, -58, -48, None, -45,
            -75, -65, -57, None, -43, -44, -38,
            -58, -45, -42, -39, -37, -35, -32,
            -38, -38, -38, -36, -35, -33, -31,
            -32, -31, -31, -32, -29, -28, -29,
            -28, -28, -27, -25, -24, -22, -22,
            -14, -15, -15, -15, -14, -11, -10,
            // sea state 5
            -80, -70, -63, -55, -44, None, -42,
            -73, -64, -52, None, -39, -39, -35,
            None, -43, -38, -35, -33, -34, -31,
            -40, -38, -35, -35, -33, -31, -30,
            -30, -30, -28, -28, -25, -23, -26,
            -28, -24, -23, -22, -22, -18, -20,
            -18, -15, -15, -15, -13, -11, -4,
            // sea state 6
            None, None, -56, None, None, None, None,
            None, None, None, None, -34, -37, -31,
            None, None, -33, None, -31, -32, None,
            None, None, None, None, -28, -28, None,
            -30, -29, -28, -27, -22, -18, None,
            -25, -32, -30, -29, -21, -16, None,
            -18, -17, -15, -14, -11, -10, None
        };
    }
}
