using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Core
{
    /// <summary>A material of the library: published values of a medium, with their source.</summary>
    public sealed class PublishedMaterial
    {
        const string Itu = "Recommendation ITU-R P.2040-3 (08/2023), table 3";
        const string Austin = "Austin RCS Benchmark Suite, University of Texas, ";

        static readonly PublishedMaterial[] Materials =
        {
            OfItu("concrete", 5.24, 0, 0.0462, 0.7822, 1, 100),
            OfItu("brick", 3.91, 0, 0.0238, 0.16, 1, 40),
            OfItu("plasterboard", 2.73, 0, 0.0085, 0.9395, 1, 100),
            OfItu("wood", 1.99, 0, 0.0047, 1.0718, 0.001, 100),
            OfItu("glass", 6.31, 0, 0.0036, 1.3394, 0.1, 100),
            OfItu("ceiling_board", 1.48, 0, 0.0011, 1.075, 1, 100),
            OfItu("chipboard", 2.58, 0, 0.0217, 0.78, 1, 100),
            OfItu("plywood", 2.71, 0, 0.33, 0, 1, 40),
            OfItu("marble", 7.074, 0, 0.0055, 0.9262, 1, 60),
            OfItu("floorboard", 3.66, 0, 0.0044, 1.3515, 50, 100),
            OfItu("metal", 1, 0, 1e7, 0, 1, 100),
            OfItu("very_dry_ground", 3, 0, 0.00015, 2.52, 1, 10),
            OfItu("medium_dry_ground", 15, -0.1, 0.035, 1.63, 1, 10),
            OfItu("wet_ground", 30, -0.4, 0.15, 1.3, 1, 10),
            new PublishedMaterial("sea_water", Medium.SeaWater(), null,
                "Meissner and Wentz, IEEE TGRS 42 (2004) 1836 and 50 (2012) 3004, at 20 C and 35 psu"),
            new PublishedMaterial("ptfe", Medium.Table(new[]
            {
                new MediumSample(2.45e9, 2.1, 2.1 * 0.0003), new MediumSample(10e9, 2.05, 2.05 * 0.0002),
                new MediumSample(70e9, 2.05, 2.05 * 0.0005), new MediumSample(110e9, 2.05, 2.05 * 0.0005)
            }), null, "Rohde & Schwarz RAC0607-0019 (2.45 GHz); Riddle et al., IEEE T-MTT 51 (2003) 727 (10 GHz); "
                + "Elhawil, IEEE/LEOS Benelux 2007 (70 to 110 GHz)"),
            new PublishedMaterial("printed_resin", Medium.Table(new[]
            {
                new MediumSample(10e6, 3.21, 0.129), new MediumSample(20e6, 3.21, 0.129),
                new MediumSample(40e6, 3.2, 0.128), new MediumSample(80e6, 3.19, 0.128),
                new MediumSample(160e6, 3.17, 0.126), new MediumSample(320e6, 3.13, 0.123),
                new MediumSample(640e6, 3.08, 0.118), new MediumSample(1280e6, 3.02, 0.108),
                new MediumSample(2560e6, 2.96, 0.0964), new MediumSample(5120e6, 2.91, 0.086),
                new MediumSample(7e9, 2.9, 0.0822), new MediumSample(10.24e9, 2.88, 0.0785)
            }), null, Austin + "problem set IIIB"),
            new PublishedMaterial("arc_dd_13490", Medium.Table(new[]
            {
                new MediumSample(10e6, 16.9, 0.339, 4.21, 0.821), new MediumSample(20e6, 16.9, 0.339, 4.21, 0.826),
                new MediumSample(40e6, 16.9, 0.339, 4.2, 0.837), new MediumSample(80e6, 16.9, 0.339, 4.19, 0.857),
                new MediumSample(160e6, 16.9, 0.339, 4.17, 0.897), new MediumSample(320e6, 16.9, 0.34, 4.13, 0.975),
                new MediumSample(640e6, 16.9, 0.341, 4.03, 1.12), new MediumSample(1280e6, 16.9, 0.343, 3.81, 1.37),
                new MediumSample(2560e6, 17, 0.353, 3.33, 1.72), new MediumSample(5120e6, 16.9, 0.393, 2.46, 1.95),
                new MediumSample(7e9, 16.9, 0.347, 1.99, 1.92), new MediumSample(10.24e9, 16.9, 0.337, 1.45, 1.73)
            }), 0.0015, Austin + "problem set IIE: silicone absorber DD-13490 of ARC Technologies, fitted to its data "
                + "sheet"),
        };

        PublishedMaterial(string name, Medium medium, double? coating, string source) =>
            (Name, Medium, Coating, Source) = (name, medium, coating, source);

        /// <summary>All materials.</summary>
        public static IReadOnlyList<PublishedMaterial> All => Materials;

        /// <summary>Name for assets and command lines: "itu_concrete".</summary>
        public string Name { get; }

        /// <summary>Its medium.</summary>
        public Medium Medium { get; }

        /// <summary>
        /// Thickness in metres at which the medium is used as a coating of metal; null: it is a half-space.
        /// </summary>
        public double? Coating { get; }

        /// <summary>Where the values are published.</summary>
        public string Source { get; }

        /// <summary>The material of a name.</summary>
        /// <exception cref="GlintException">There is none; the message lists the names.</exception>
        public static PublishedMaterial Find(string name) => Array.Find(Materials, it => it.Name == name)
            ?? throw new GlintException($"no published material is called {Values.Shown(name)}: give one of "
                + string.Join(", ", Materials.Select(it => it.Name)));

        /// <summary>A surface of it: a half-space, or a coating on metal.</summary>
        /// <param name="name">Name of the surface's material.</param>
        public SurfaceMaterial ToSurface(string name) => Coating is double thickness
            ? new SurfaceMaterial(name, new[] { new MaterialLayer(Medium, thickness) })
            : new SurfaceMaterial(name, halfSpace: Medium);

        static PublishedMaterial OfItu(string name, double a, double b, double c, double d, double from, double to) =>
            new PublishedMaterial("itu_" + name, Medium.PowerLaw(a, b, c, d, from * 1e9, to * 1e9), null, Itu);
    }
}
