using System.IO;
using System.Linq;
using System.Text;
using System.Xml.Linq;
using Glint.Cli;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>Plots of glint bench --rcs-plots, and the tables they show.</summary>
public sealed class CrossSectionPlotTests
{
    // Values outside the range lie on its ends: 100 dBsm on the upper one of -10 to 10, no echo on the lower one.
    [Test]
    public void Plot_HasALineACurveAndPolarisation_WithinItsRange()
    {
        var stream = new MemoryStream();
        CrossSectionPlot.Write(stream, "title <1>", "angle", (-10, 10),
            new CrossSectionCurve("theirs", [(0, 0, 5), (90, 10, -5)]),
            new CrossSectionCurve("ours", [(0, 100, 0), (45, 0, 0), (90, double.NegativeInfinity, 0)]));

        var svg = XDocument.Parse(Encoding.UTF8.GetString(stream.ToArray())).Root;
        double[][] heights = [.. svg.Elements().Where(element => element.Name.LocalName == "polyline")
            .Select(line => line.Attribute("points").Value.Split(' ').Select(point => double.Parse(point.Split(',')[1]))
                .ToArray())];
        Assert.That(heights.Select(line => line.Length), Is.EqualTo(new[] { 2, 3, 2, 3 }));
        // 10 dBsm of theirs is where 100 of ours are drawn, their 0 where ours is 0, and nothing as far below it.
        Assert.That(heights[1][0], Is.EqualTo(heights[0][1]));
        Assert.That(heights[1][1], Is.EqualTo(heights[0][0]));
        Assert.That(heights[1][2] - heights[1][1], Is.EqualTo(heights[1][1] - heights[1][0]).Within(0.11));
        Assert.That(svg.Value, Does.Contain("title <1>").And.Contain("theirs").And.Contain("VV, dBsm"));
    }

    // Geometric optics backwards, and forwards the lobe of a shadow of the sphere's section: 4 pi A^2 / wavelength^2.
    // The waves at the shadow's border add a part of the order of (ka)^(-2/3).
    [Test]
    public void Mie_OfALargeSphere_IsGeometricOpticsAndItsShadow()
    {
        var rows = PublishedCrossSections.Read("sphere_mie");
        const double radius = 0.5;
        double section = System.Math.PI * radius * radius, wavelength = Signal.Wavelength(10e9);
        double forward = 4 * System.Math.PI * section * section / (wavelength * wavelength);
        Assert.That(rows.Select(row => row.Degrees), Is.EqualTo(Enumerable.Range(0, 361).Select(i => i / 2.0)));
        Assert.That(rows[0].VV, Is.EqualTo(PowerLevel.ToDecibels(section)).Within(0.05));
        Assert.That(rows[360].VV, Is.EqualTo(PowerLevel.ToDecibels(forward)).Within(0.4));
        // One plane of symmetry: both polarisations are the same on the axis.
        Assert.That(rows[0].HH, Is.EqualTo(rows[0].VV));
        Assert.That(rows[360].HH, Is.EqualTo(rows[360].VV));
    }

    [Test]
    public void Folder_OfThePlots_IsMade()
    {
        string parent = Directory.CreateTempSubdirectory("glint-plots-").FullName,
            folder = Path.Combine(parent, "figures", "rcs");
        try
        {
            OutputFile.In("--rcs-plots", folder, ["a.svg"]).Single().Write(stream => stream.WriteByte(1));
            Assert.That(File.Exists(Path.Combine(folder, "a.svg")));
            Assert.That(() => OutputFile.In("--rcs-plots", Path.Combine(folder, "a.svg"), ["b.svg"]),
                Throws.TypeOf<GlintException>().With.Message.StartsWith("--rcs-plots ").And.Message.Contains("a.svg"));
        }
        finally
        {
            Directory.Delete(parent, true);
        }
    }

    [Test]
    public void Table_ThatIsNotThere_IsNamed() => Assert.That(() => PublishedCrossSections.Read("cube"),
        Throws.TypeOf<GlintException>().With.Message.Contains("cube.csv: the published table is missing"));
}
