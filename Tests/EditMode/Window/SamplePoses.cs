using Glint.Core;

namespace Glint.Tests
{
    /// <summary>Poses with chosen figures.</summary>
    static class SamplePoses
    {
        /// <param name="amplitude">Amplitude for a picture of 2,073,600 rays, which equals the normalised one.</param>
        public static StoredRow At(SweepPose pose, double amplitude, double error = 0, long received = 1,
            long hit = 1) => new StoredRow(new SweepRow(pose, new RadarResult(new RadarSums
            {
                InPhase = amplitude, RaysOfPicture = 2073600, RaysEmitted = 2073600, RaysHit = hit,
                RaysReceived = received
            }, new SamplingReport(error, 0, false))));

        public static StoredRow At(double angle, double amplitude, double error = 0) =>
            At(new SweepPose(angle), amplitude, error);

        /// <summary>A pose without a sampling error.</summary>
        public static StoredRow NotEstimated(double angle, double amplitude) => new StoredRow(new SweepRow(
            new SweepPose(angle), new RadarResult(new RadarSums { InPhase = amplitude, RaysOfPicture = 2073600 })));

        /// <summary>A pose with values of two axes.</summary>
        public static StoredRow At(SweepAxis first, double a, SweepAxis second, double b, double amplitude = 1) =>
            At(new SweepPlan((first, new[] { a }), (second, new[] { b }))[0], amplitude);
    }
}
