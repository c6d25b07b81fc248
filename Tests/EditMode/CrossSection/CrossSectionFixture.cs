namespace Glint.Tests
{
    /// <summary>One tracer of cross sections for all tests of a class.</summary>
    public abstract class CrossSectionFixture : TracerFixture<CrossSectionTracer>
    {
        protected override CrossSectionTracer Make() => new CrossSectionTracer(TestKernels.Tubes);
    }
}
