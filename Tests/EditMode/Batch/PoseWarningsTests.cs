using System.Text.RegularExpressions;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Glint.Tests
{
    /// <summary>What is said at the end of a run or sweep.</summary>
    public sealed class PoseWarningsTests
    {
        [Test]
        public void Log_OfEchoesThatMissTheirTolerance_SaysOfHowMany()
        {
            var warnings = new PoseWarnings();
            foreach (bool isMet in new[] { true, false, false })
                warnings.Add(Row(isMet));
            LogAssert.Expect(LogType.Warning, new Regex("^Scene: .*cross sections.* 1 dB in 2 of the poses traced"));
            warnings.Log("Scene", hasTolerance: true);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void Log_OfEchoesThatMeetIt_SaysNothing()
        {
            var warnings = new PoseWarnings();
            warnings.Add(Row(isMet: true));
            warnings.Log("Scene", hasTolerance: true);
            LogAssert.NoUnexpectedReceived();
        }

        static RadarResult Row(bool isMet) => new RadarResult(new RadarSums { RaysHit = 3, RaysReceived = 2 })
            .With(PoseEcho.Of(new CrossSectionResult(1, 1) { IsMet = isMet }));
    }
}
