using System;
using System.Diagnostics;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Time that this process computes: other programs on the machine do not count.</summary>
    static class ProcessorTime
    {
        /// <summary>Fails if something takes longer.</summary>
        /// <returns>What it gives.</returns>
        public static T Within<T>(double seconds, Func<T> what)
        {
            var start = Now;
            var result = what();
            double took = (Now - start).TotalSeconds;
            TestContext.WriteLine(FormattableString.Invariant($"{took:0.00} s of processor time"));
            Assert.That(took, Is.LessThan(seconds), "seconds of processor time");
            return result;
        }

        static TimeSpan Now
        {
            get
            {
                using (var process = Process.GetCurrentProcess())
                    return process.TotalProcessorTime;
            }
        }
    }
}
