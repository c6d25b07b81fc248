namespace Glint.Core
{
    /// <summary>
    /// The echo of a radar's picture of a scene with a sea, at the range of its phase centre. Signal is what met
    /// anything but the sea on its way, by way of the sea too; clutter is the rest.
    /// </summary>
    public sealed class PoseEcho
    {
        readonly ScatteringMatrix _all, _sea;
        readonly ClutterEcho _clutter;

        PoseEcho(in ScatteringMatrix all, in ScatteringMatrix sea, in ClutterEcho clutter, bool isMet) =>
            (_all, _sea, _clutter, IsMet) = (all, sea, clutter, isMet);

        /// <summary>The echo of a cross section with one receiver and one frequency.</summary>
        public static PoseEcho Of(CrossSectionResult result) =>
            new PoseEcho(result.S[0, 0], result.Sea[0, 0], result.Clutter[0], result.IsMet);

        /// <summary>Whether its amplitudes have the error asked for.</summary>
        public bool IsMet { get; }

        /// <summary>
        /// Cross section of signal and clutter together, with the speckle of this moment, dBsm; null for 0.
        /// </summary>
        public double? SigmaDbsm(Polarisation polarisation) => Decibels(PowerLevel.Of(polarisation.Of(_all)));

        /// <summary>Cross section of the clutter, its mean over the speckle, dBsm; null for 0.</summary>
        public double? ClutterDbsm(Polarisation polarisation) => Decibels(Clutter(polarisation));

        /// <summary>Signal over clutter, its mean over the speckle, dB; null if either is 0.</summary>
        public double? SignalToClutterDb(Polarisation polarisation)
        {
            double clutter = Clutter(polarisation);
            return clutter > 0
                ? Decibels(PowerLevel.Of(polarisation.Of(_all) - polarisation.Of(_sea)) / clutter)
                : null;
        }

        // Mirror paths of the sea, and its diffuse echo.
        double Clutter(Polarisation polarisation) =>
            PowerLevel.Of(polarisation.Of(_sea) - polarisation.Of(_clutter.S)) + _clutter.SigmaOf(polarisation);

        static double? Decibels(double power) => power > 0 ? PowerLevel.ToDecibels(power) : (double?)null;
    }
}
