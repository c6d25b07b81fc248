using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>One tracer of clutter for all tests of a class.</summary>
    public abstract class ClutterFixture
    {
        protected ClutterTracer Tracer { get; private set; }

        [OneTimeSetUp]
        public void MakeTracer() => Tracer = new ClutterTracer(TestKernels.Tubes);

        [OneTimeTearDown]
        public void DisposeTracer() => Tracer.Dispose();
    }
}
