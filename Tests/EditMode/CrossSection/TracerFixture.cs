using System;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>One tracer for all tests of a class.</summary>
    public abstract class TracerFixture<T> where T : IDisposable
    {
        protected T Tracer { get; private set; }

        [OneTimeSetUp]
        public void MakeTracer() => Tracer = Make();

        [OneTimeTearDown]
        public void DisposeTracer() => Tracer.Dispose();

        protected abstract T Make();
    }
}
