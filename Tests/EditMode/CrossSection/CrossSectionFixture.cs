using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>One tracer of cross sections for all tests of a class.</summary>
    public abstract class CrossSectionFixture
    {
        protected CrossSectionTracer Tracer { get; private set; }

        [OneTimeSetUp]
        public void MakeTracer() => Tracer = new CrossSectionTracer(TestKernels.Tubes);

        [OneTimeTearDown]
        public void DisposeTracer() => Tracer.Dispose();
    }
}
