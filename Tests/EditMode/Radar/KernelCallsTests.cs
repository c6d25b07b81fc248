using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Dispatches of one thread an element.</summary>
    public sealed class KernelCallsTests
    {
        // 65,535 rows of 64 groups of 64 threads. Unity drops a larger dispatch without a word.
        [Test]
        public void DispatchThreads_MoreThanADeviceTakes_IsRefused()
        {
            int kernel = TestKernels.Trace.FindKernel("Arithmetic");
            Assert.That(KernelCalls.MaxThreads, Is.EqualTo(65535L * 64 * 64));
            Assert.That(() => TestKernels.Trace.DispatchThreads(kernel, KernelCalls.MaxThreads + 1),
                Throws.TypeOf<GlintException>().With.Message.EndWith("needs 268,431,361 threads at once, and a device takes "
                    + "268,431,360: the scene has too many triangles"));
        }
    }
}
