namespace Glint.Tests
{
    /// <summary>One tracer of clutter for all tests of a class.</summary>
    public abstract class ClutterFixture : TracerFixture<ClutterTracer>
    {
        protected override ClutterTracer Make() => new ClutterTracer(TestKernels.Tubes);
    }
}
