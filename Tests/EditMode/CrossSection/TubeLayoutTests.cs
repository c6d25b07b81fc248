using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using Glint.Core;
using NUnit.Framework;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>Structs and constants of ray tubes are the same in C# and HLSL.</summary>
    public sealed class TubeLayoutTests
    {
        [Test]
        public void Structs_AreWholeRowsOfSixteenBytes()
        {
            Assert.That(Marshal.SizeOf<Tube>(), Is.EqualTo(112));
            Assert.That(Marshal.SizeOf<TubeCell>(), Is.EqualTo(64));
            Assert.That(Marshal.SizeOf<TubePose>(), Is.EqualTo(240));
            Assert.That(Marshal.SizeOf<AmplitudePose>(), Is.EqualTo(112));
            Assert.That(Marshal.SizeOf<BorderRay>(), Is.EqualTo(32));
            Assert.That(Marshal.SizeOf<TubeCorner>(), Is.EqualTo(64));
            Assert.That(Marshal.SizeOf<EdgePiece>(), Is.EqualTo(64));
            Assert.That(Marshal.SizeOf<SeaFacet>(), Is.EqualTo(32));
            Assert.That(Marshal.SizeOf<SeaTileRecord>(), Is.EqualTo(96));
        }

        [Test]
        public void Structs_ReadByAKernel_HaveTheFieldsThatCSharpWrote()
        {
            var tube = new Tube
            {
                Gradient = float2(1, 2), Phase = 3, Tag = 4, CoPolar = float4(5, 6, 7, 8),
                CrossPolar = float4(9, 10, 11, 12), Corners01 = float4(13, 14, 15, 16),
                Corners23 = float4(17, 18, 19, 20), Corner4 = float2(21, 22), Error = 23, Bent = 24,
                Bends = float3(165, 166, 167), Slope = 168
            };
            var cell = new TubeCell
            {
                Position = uint2(25, 26), Level = 27, FirstBounce = 28, Signatures = uint4(29, 30, 31, 32),
                Strength = 33, Thinned = 34, Crossings = uint2(35, 36), Pose = 161, Number = 162, Whole = 163,
                Traits = 164
            };
            var piece = new EdgePiece
            {
                Centre = float3(37, 38, 39), Length = 40, Along = float3(41, 42, 43), OuterAngle = 44,
                Into = float3(45, 46, 47), Part = 48, Instance = 81, Unused = uint3(82, 83, 84)
            };
            var facet = new SeaFacet { Centre = float3(49, 50, 51), IsBreaking = 52, Section = float3(53, 54, 55), LogWind = 56 };
            var tile = new SeaTileRecord
            {
                X = float4(57, 58, 59, 60), Y = float4(61, 62, 63, 64), Z = float4(65, 66, 67, 68),
                SectionX = float3(69, 70, 71), Number = 72, SectionY = float3(73, 74, 75), Unused = 76,
                SectionZ = float3(77, 78, 79), Unused2 = 80
            };
            var corner = new TubeCorner
            {
                Signature = 85, Traits = 86, Strength = 87, Changes = 88, Position = float4(89, 90, 91, 92),
                AlongU = float4(93, 94, 95, 96), AlongV = float4(97, 98, 99, 100)
            };
            Unity.Mathematics.float4 Row(float first) => float4(first, first + 1, first + 2, first + 3);
            var pose = new TubePose
            {
                Origin = Row(101), OriginDx = Row(105), OriginDy = Row(109), Direction = Row(113), DirectionDx = Row(117),
                DirectionDy = Row(121), SentV = Row(125).xyz, CrossWeight = 128, SentH = Row(129), GridX = Row(133), GridY = Row(137),
                GridDepth = Row(141), Slice = uint4(145, 146, 147, 148), Cells = uint2(149, 150), Blocks = uint2(151, 152),
                Reference = float2(153, 154), FirstCorner = 155, OriginDepth = 156, RadarPhase = 157,
                CellError = 158, MaxLevel = 159, MaxBisections = 160
            };
            var picture = new AmplitudePose
            {
                Aside = Row(169), ReceiverCentre = Row(173), ReceiverRight = Row(177), ReceiverUp = Row(181),
                ReceiverForward = Row(185), PictureStart = float2(189, 190), PictureStep = float2(191, 192), EmptyLevel = 193,
                FirstInstance = 194, FirstRow = 195, Unused = 196
            };
            bool IsWhole(int field) => field == 4 || field >= 25 && field <= 32 || field == 35 || field == 36
                || field == 48 || field == 52 || field == 72 || field == 76 || field == 80
                || field >= 81 && field <= 86 || field == 88 || field >= 145 && field <= 152 || field == 155 || field >= 159 && field <= 164 || field == 168
                || field >= 193;
            using (var fields = new ShaderFields(TestKernels.TubeLayout))
            {
                fields.Bind("_TubeIn", tube);
                fields.Bind("_CellIn", cell);
                fields.Bind("_EdgePieceIn", piece);
                fields.Bind("_SeaFacetIn", facet);
                fields.Bind("_SeaTileIn", tile);
                fields.Bind("_CornerIn", corner);
                fields.Bind("_TubePoseIn", pose);
                fields.Bind("_AmplitudePoseIn", picture);
                Assert.That(fields.Unpack(196), Is.EqualTo(Enumerable.Range(1, 196)
                    .Select(i => IsWhole(i) ? (uint)i : asuint((float)i))));
            }
        }

        // A name without a counterpart fails on either side.
        [Test]
        public void Constants_OfTheKernels_AreThoseOfCSharp()
        {
            var constants = ShaderConstants.Of("TubeBindings.hlsl");
            Assert.That(constants.Where(constant => !s_ofTheDevice.Contains(constant.Key)), Is.EquivalentTo(
                new Dictionary<string, double>
                {
                    ["TUBE_COUNT"] = TubeSums.Count, ["TUBE_OVERFLOW"] = TubeSums.Overflow,
                    ["MAX_POSES"] = TubeKernels.MaxPoses, ["POSE_COUNTS"] = TubeSums.FirstPose,
                    ["POSE_COUNT_WORDS"] = TubeSums.PoseWords, ["POSE_PARTS"] = TubeSums.PoseParts, ["POSE_TUBES"] = TubeSums.PoseTubes,
                    ["POSE_RAYS"] = TubeSums.PoseRays, ["POSE_BORDER_RAYS"] = TubeSums.PoseBorderRays,
                    ["POSE_BOUNCES"] = TubeSums.PoseBounces,
                    ["TUBE_SUMS"] = TubeKernels.FirstSum, ["RECEIVER_ROWS"] = 3,
                    ["TUBE_SUM_WORDS"] = TubeKernels.SumWords,
                    // Sums have two words.
                    ["SUM_S"] = 0, ["SUM_BENT"] = 2 * TubeSums.Bent, ["SUM_ERROR"] = 2 * TubeSums.Border,
                    ["SUM_CROSS_BENT"] = 2 * TubeSums.CrossBent, ["SUM_CROSS_ERROR"] = 2 * TubeSums.CrossBorder,
                    ["SUM_TUBE_OVERFLOW"] = TubeSums.TooLarge,
                    ["MAX_RECEIVERS"] = TubeKernels.MaxReceivers,
                    ["BAND_FREQUENCIES"] = TubeBands.MaxFrequencies, ["BAND_ROWS"] = TubeBands.Rows,
                    ["REFLECTION_STEPS"] = SurfaceBuffers.ReflectionSteps, ["PLACE_ROWS"] = SurfaceBuffers.PlaceRows,
                    ["FLAT"] = PatchBuffers.Flat,
                    ["COVER_SIDE"] = TubeKernels.CoverSide, ["REVEALED_WORDS"] = TubeKernels.RevealedWords,
                    ["PART_WORDS"] = TubeKernels.PartWords, ["AMPLITUDE_REVEALED"] = AmplitudeSums.RevealedParts,
                    ["AMPLITUDE_HITS"] = AmplitudeSums.Hits, ["AMPLITUDE_BOUNCES"] = AmplitudeSums.Bounces,
                    ["AMPLITUDE_RECEIVED"] = AmplitudeSums.Received, ["AMPLITUDE_LENGTHS"] = AmplitudeSums.Lengths,
                    ["AMPLITUDE_LENGTH_UNITS"] = AmplitudeSums.LengthUnits, ["AMPLITUDE_RAYS"] = AmplitudeSums.Rays,
                    ["AMPLITUDE_COPIES"] = AmplitudeSums.Copies, ["AMPLITUDE_WORDS"] = AmplitudeSums.CountWords,
                    ["BORDER_ARGUMENTS"] = TubeRounds.BorderArguments,
                    ["CELL_ARGUMENTS"] = TubeRounds.CellArguments, ["TUBE_ARGUMENTS"] = TubeRounds.TubeArguments,
                    ["BISECT_ARGUMENTS"] = TubeRounds.BisectArguments,
                    ["CORNER_ARGUMENTS"] = TubeRounds.CornerArguments,
                    ["CENTRE_ARGUMENTS"] = TubeRounds.CentreArguments,
                    ["OUTLINE_ARGUMENTS"] = TubeRounds.OutlineArguments, ["WHOLE_ARGUMENTS"] = TubeRounds.WholeArguments,
                    ["CHANGE_ARGUMENTS"] = TubeRounds.ChangeArguments,
                    ["BORDER_RAY_ARGUMENTS"] = TubeRounds.BorderRayArguments,
                    ["NEW_CORNERS"] = TubeKernels.NewCorners, ["BORDER_RAYS"] = AmplitudeKernels.BorderRays,
                    ["CENTRE_WORDS"] = TubeLists.CentreWords,
                    ["TUBE_EXTRAS"] = TubeKernels.TubeExtras,
                    ["BLOCK_CELLS"] = TubeKernels.BlockCells, ["BLOCK_CORNERS"] = TubeKernels.BlockCorners,
                    ["VERTEX_LINKS"] = TubeKernels.VertexLinks, ["SIDE_ROWS"] = TubeKernels.SideRows,
                    ["LINE_LINKS"] = TubeKernels.LineLinks, ["SILHOUETTE_ROWS"] = TubeKernels.SilhouetteRows,
                    ["MIRROR_ROWS"] = TubeKernels.MirrorRows, ["OUTLINE_ROWS"] = TubeKernels.OutlineRows
                }));
            Assert.That(s_ofTheDevice, Is.SubsetOf(constants.Keys));
        }

        [Test]
        public void Constants_OfTheSea_AreThoseOfCSharp() =>
            Assert.That(ShaderConstants.Of("SeaFacets.hlsl"), Is.EquivalentTo(new Dictionary<string, double>
            {
                ["SEA_FIELD"] = ClutterSums.Field, ["SEA_POWER"] = ClutterSums.Power, ["SEA_AREA"] = ClutterSums.Area,
                ["SEA_LIT_AREA"] = ClutterSums.LitArea, ["SEA_OVERFLOW"] = ClutterSums.Overflow,
                ["SEA_FIELD_UNITS"] = ClutterSums.FieldUnits,
                ["SEA_POWER_UNITS"] = ClutterSums.PowerUnits, ["SEA_AREA_UNITS"] = ClutterSums.AreaUnits,
                ["SEA_SUM_WORDS"] = ClutterSums.SumWords, ["SEA_MAX_UNITS"] = 4e18, ["SEA_MAX_POWER_UNITS"] = 1e28,
                // Of hashes: neither is a time of speckle.
                ["SEA_CHOICE"] = ShaderConstants.Of("Speckle.hlsl")["NO_TIME"] + 1,
                ["GRAVITY"] = SeaSpectrum.Gravity, ["TENSION"] = ClutterMotion.Tension
            }));

        [Test]
        public void Rows_OfALight_AreThoseOfCSharp()
        {
            var rows = ShaderConstants.Of("SeaLights.hlsl");
            Assert.That(rows["LIGHT_ROWS"], Is.EqualTo(ShipSeaKernel.Rows));
            Assert.That(rows.Values, Is.EquivalentTo(Enumerable.Range(0, ShipSeaKernel.Rows + 1)));
        }

        [Test]
        public void Constants_OfSigma_AreThoseOfCSharp() =>
            Assert.That(ShaderConstants.Of("SeaSigma.hlsl"), Is.EquivalentTo(new Dictionary<string, double>
            {
                ["FACET_ROWS"] = FacetTable.Rows, ["FACET_COLUMNS"] = FacetTable.Columns
            }));

        // Sums and counts share a buffer, and the arguments of dispatches another one.
        [Test]
        public void Words_DoNotOverlap()
        {
            var constants = ShaderConstants.Of("TubeBindings.hlsl");
            // Lists that are filled from both ends have two counts.
            var counts = new[] { "COUNT", "OVERFLOW", "OUTLINES" }.Select(name => constants["TUBE_" + name])
                .Concat(new[] { "CELLS", "NEXT_CELLS", "CENTRES", "BORDERS", "WHOLES" }
                    .SelectMany(name => new[] { constants["TUBE_" + name], constants["TUBE_" + name] + 1 })).ToArray();
            Assert.That(counts, Is.Unique);
            Assert.That(counts, Is.All.LessThan(TubeSums.FirstPose));
            Assert.That(TubeSums.FirstPose + TubeSums.PoseWords * TubeSums.PoseParts * TubeKernels.MaxPoses, Is.EqualTo(TubeKernels.FirstSum));
            Assert.That(2 * TubeSums.SumCount, Is.EqualTo(TubeSums.TooLarge));
            Assert.That(TubeSums.TooLarge, Is.LessThan(TubeKernels.SumWords));
            Assert.That(new[] { AmplitudeSums.Rays, AmplitudeSums.Hits, AmplitudeSums.Bounces, AmplitudeSums.Received,
                AmplitudeSums.RevealedParts, AmplitudeSums.Lengths, AmplitudeSums.Lengths + 1 }, Is.Unique
                .And.All.LessThan(AmplitudeSums.CountWords));
            uint[] arguments = { TubeRounds.BorderArguments, TubeRounds.CellArguments, TubeRounds.TubeArguments,
                TubeRounds.BisectArguments, TubeRounds.CornerArguments, TubeRounds.CentreArguments,
                TubeRounds.OutlineArguments, TubeRounds.WholeArguments, TubeRounds.ChangeArguments,
                TubeRounds.BorderRayArguments };
            Assert.That(arguments.OrderBy(offset => offset), Is.EqualTo(new[] { 0, 12, 24, 36, 48, 60, 72, 84, 96, 108 }));
            Assert.That(4 * TubeRounds.ArgumentWords, Is.EqualTo(108 + 12));
        }

        // Tags of tubes have 8 bits for the receiver, 8 for the bounce, and the corners above.
        [Test]
        public void Tag_HoldsReceiverBounceAndCorners()
        {
            Assert.That(2 * TubeKernels.MaxReceivers, Is.LessThanOrEqualTo(TubeSums.MaxSlots));
            Assert.That(TubeSums.MaxSlots, Is.EqualTo(256));
            Assert.That(Core.RadarSettings.BounceLimit, Is.LessThanOrEqualTo(255));
            Assert.That(ShaderConstants.Of("TubeBindings.hlsl")["EDGE_CORNERS"],
                Is.GreaterThan(5).And.LessThan(65536), "polygons have 5 corners");
        }

        static readonly string[] s_ofTheDevice = { "DEEP_CELL", "BENT_CELL", "KINKED_CELL", "EDGE_CELL", "THIN_PART_SHIFT", "CHANGES", "TUBE_CELLS", "TUBE_BORDERS", "TUBE_WHOLES",
            "TUBE_NEXT_CELLS", "TUBE_CENTRES", "TUBE_OUTLINES", "EDGE_CORNERS", "TUBES_A_GROUP", "MAX_COVERED", "MAX_SIDES", "MAX_LISTED",
            "TUBE_POINTS", "MAX_SHADOWS", "MAX_IMAGES", "SHADOW_LINE", "IMAGE_LINE",
            "SHADOW_RAY", "LIT_RAY", "IMAGE_RAY" };
    }
}
