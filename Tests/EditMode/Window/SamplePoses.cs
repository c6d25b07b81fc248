using Glint.Core;
using Glint.Editor;

namespace Glint.Tests
{
    /// <summary>Poses with chosen figures.</summary>
    static class SamplePoses
    {
        /// <param name="amplitude">Of a picture of 2,073,600 rays, so that the normalised one is the same.</param>
        public static PoseFigures At(SweepPose pose, double amplitude, double error = 0, long received = 1,
            long hit = 1) => new PoseFigures(new StoredRow(new SweepRow(pose, new RadarResult(new RadarSums
            {
                InPhase = amplitude, RaysOfPicture = 2073600, RaysEmitted = 2073600, RaysHit = hit,
                RaysReceived = received
            }, new SamplingReport(error, 0, false)))));

        public static PoseFigures At(double angle, double amplitude, double error = 0) =>
            At(new SweepPose(angle), amplitude, error);

        /// <summary>At a place on two axes.</summary>
        public static PoseFigures At(SweepAxis first, double a, SweepAxis second, double b, double amplitude = 1) =>
            At(new SweepPlan((first, new[] { a }), (second, new[] { b }))[0], amplitude);
    }
}
