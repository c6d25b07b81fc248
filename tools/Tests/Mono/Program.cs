using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Threading;
using Glint.Core;
using NUnit.Framework.Api;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace Glint.Tests.Mono;

/// <summary>
/// Runs the tests of this assembly that are neither slow nor long with NUnit's own runner; the last line is
/// "N passed, N failed". With <c>--hold FOLDER</c> it opens a results folder and holds it until it is killed.
/// </summary>
static class Program
{
    // They take more than half of the time, and what they prove does not depend on the runtime: integrals and statistics in
    // double precision, and meshes so large that a build takes seconds.
    static readonly string[] s_long =
    [
        nameof(CfarTests.FalseAlarms_AtTheEdges_AreAsManyAsInside),
        nameof(CfarTests.FalseAlarms_InNoise_AreAsManyAsAskedFor),
        nameof(CfarTests.FalseAlarms_InKClutter_RiseWithItsSpikes),
        nameof(ClutterStatisticsTests.Shapes_OfKDistributedSamples_AreTheirs),
        nameof(DopplerCentroidTests.Centroid_AgainstTheWind_IsNearTheClosedFormAndCdop),
        nameof(EchoDetectionTests.FalseAlarms_OfAMap_AreAsManyAsAskedFor),
        nameof(FacetTableTests.Read_OfAFacet_IsTheMeanOverItsUnresolvedSlopes),
        nameof(FacetTableTests.Read_OverResolvedSlopes_IsTheTwoScaleMean),
        nameof(FrequencyGroupsTests.LargerError_TakesFewerTraces),
        nameof(GustsTests.Facet_InAGust_ScattersAsInItsWind),
        nameof(IsarTransformTests.Image_FromATrack_HasPointsAtTheirPlacesWithTheirCrossSections),
        nameof(MeshBvhTests.Build_LargeMeshMostlyInAClump_IsCutIntoFewParts),
        nameof(MeshBvhTests.Build_PairsOrNoPairs_TakesAtMost120BytesATriangle),
        nameof(MeshQualityTests.PublishedSphere_IsGoodAtTenGigahertz),
        nameof(ScatterometerTests.MeanEcho_AtCBand_IsNearTheScatterometers),
        nameof(ShipModelTests.Build_OfALargeShip_FollowsItsHullAtTenGigahertz),
        nameof(ShipModelTests.Build_OfALargeShip_IsClosedWithoutNeedles),
        nameof(SpeckleTests.Between_FallsLikeAGaussian),
        nameof(SurfacePatchesTests.HalfAMillionTriangles_WithoutSharedVertices_TakeThreeSeconds),
        nameof(SurfacePatchesTests.RotatedAndShuffled_HasTheSamePatchesAndNormals),
        nameof(WedgeFinderTests.HalfAMillionTriangles_TakeASecond),
        nameof(WeldedMeshTests.HalfAMillionTriangles_WithoutSharedVertices_AreWeldedInASecond)
    ];

    static readonly TestFilter Filter = TestFilter.FromXml("<filter><not><or><cat>Slow</cat>"
        + string.Concat(s_long.Select(name => $"<method>{name}</method>")) + "</or></not></filter>");

    static int Main(string[] arguments)
    {
        if (arguments.Length == 2 && arguments[0] == "--hold")
            return HoldFolder(arguments[1]);
        var runner = new NUnitTestAssemblyRunner(new DefaultTestAssemblyBuilder());
        runner.Load(Assembly.GetExecutingAssembly(), new Dictionary<string, object>());
        var result = runner.Run(new Listener(Console.Out), Filter);
        int failed = result.FailCount + result.SkipCount + result.InconclusiveCount;
        // A fixture whose set-up fails counts no test.
        if (failed == 0 && (result.PassCount == 0 || result.ResultState.Status != TestStatus.Passed))
            failed = 1;
        Console.WriteLine($"{result.PassCount} passed, {failed} failed");
        return failed == 0 ? 0 : 1;
    }

    static int HoldFolder(string folder)
    {
        try
        {
            using (ResultsFolder.Open(folder))
                Thread.Sleep(Timeout.Infinite);
            return 0;
        }
        catch (GlintException error)
        {
            Console.Error.WriteLine(error.Message);
            return error.ExitCode;
        }
    }

    /// <param name="output">Kept, since NUnit takes the console's during a test.</param>
    sealed class Listener(TextWriter output) : ITestListener
    {
        public void TestFinished(ITestResult result)
        {
            if (!result.HasChildren && result.ResultState.Status != TestStatus.Passed)
                output.WriteLine($"{result.ResultState} {result.FullName}\n{result.Message}\n{result.StackTrace}");
        }

        public void TestStarted(ITest test)
        {
        }

        public void TestOutput(TestOutput text)
        {
        }

        public void SendMessage(TestMessage message)
        {
        }
    }
}
