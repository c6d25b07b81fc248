using System;
using System.IO;
using System.Linq;
using System.Text;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>glint echo with the pattern of an antenna: received power, files that follow it, refusals.</summary>
[Category("Slow")]
public sealed class EchoAntennaTests : EchoFixture
{
    const double Radius = 0.3, Distance = 1000, GainDb = 25;

    static readonly string[] s_echo =
        ["--edges", "off", "--polarisation", "vv", "--tolerance", "0.3", "--frequencies", "64", "--bandwidth", "600e6",
            "--range", "1000", "--power", "50"];

    static readonly string[] s_antenna = [.. s_echo, "--gain", "25", "--antenna", "gaussian", "--beam", "2,8"];

    /// <summary>
    /// Pt G^2 lambda^2 pi a^2 / ((4 pi)^3 R^4) in the middle of the beam, at the range of the sphere's front. Physical
    /// optics differs from pi a^2 by the echo of the shadow's border, a bin behind the front and 1 / (2 k a) of its
    /// amplitude, 0.1 dB; the tolerance is 0.3 dB. Squint and tilt change the power by the pattern alone, out and back.
    /// </summary>
    [Test]
    public void Sphere_OffTheMiddleOfTheBeam_HasThePowerOfThePattern()
    {
        File.WriteAllText(At("sphere.obj"), Sphere());
        double Peak(params string[] options)
        {
            Run([At("sphere.obj"), .. s_antenna, "--elevation", "5", .. options, "--out", At("echo")]);
            var highest = Table("echo/profile.csv").MaxBy(line => Number(line, "vv_dbw"));
            Assert.That(Number(highest, "range_m"), Is.EqualTo(-Radius).Within(0.03));
            return Number(highest, "vv_dbw");
        }
        double front = Distance - Radius, middle = Peak(), expected = 10 * Math.Log10(50 * Wavelength * Wavelength
            * Math.PI * Radius * Radius / (Math.Pow(4 * Math.PI, 3) * Math.Pow(front, 4))) + 2 * GainDb;
        Assert.That(middle, Is.EqualTo(expected).Within(0.4));
        double half = 20 * Math.Log10(0.5);
        Assert.That(Peak("--squint", "1"), Is.EqualTo(middle + half).Within(1e-6));
        // 5 degrees below the horizontal; the beam is 1 degree below.
        Assert.That(Peak("--tilt", "-1"), Is.EqualTo(middle + half).Within(1e-6));
        Assert.That(Peak("--tilt", "-1", "--squint", "-2"), Is.EqualTo(middle + 5 * half).Within(1e-6));
    }

    /// <summary>A table goes with the results: parts and resumption need no file, and have its power.</summary>
    [Test]
    public void Table_IsKeptWithTheResults()
    {
        string pattern = At("pattern.csv");
        File.WriteAllText(pattern, "angle_deg,azimuth_db,elevation_db\n-20,-30,-20\n0,0,0\n20,-30,-20\n");
        string[] echo = [At("plate.obj"), .. s_echo, "--azimuth", "0,1", "--antenna", pattern, "--squint", "3"];
        Run([.. echo, "--out", At("whole")]);
        Run([.. echo, "--shard", "1/2", "--out", At("a")]);
        Run([.. echo, "--shard", "2/2", "--out", At("b")]);
        File.Delete(pattern);
        var (code, _, error) = TestShell.Run("merge", At("a"), At("b"), "--out", At("merged"));
        Assert.That(code, Is.Zero, error);
        Assert.That(File.ReadAllBytes(At("merged/profile.csv")), Is.EqualTo(File.ReadAllBytes(At("whole/profile.csv"))));
        double field = 1 + 3.0 / 20 * (Math.Pow(10, -1.5) - 1);
        // 26000 over the product of the table's widths between fields of the root of a half.
        double azimuth = 40 * (1 - Math.Sqrt(0.5)) / (1 - Math.Pow(10, -1.5)),
            elevation = 40 * (1 - Math.Sqrt(0.5)) / (1 - 0.1), gain = 26000 / (azimuth * elevation);
        double sigma = 4 * Math.PI * Math.Pow(Width * Height / Wavelength, 2), power = 50 * gain * gain
            * Math.Pow(field, 4) * Wavelength * Wavelength * sigma / (Math.Pow(4 * Math.PI, 3) * 1e12);
        Assert.That(Table("whole/profile.csv").Max(line => Number(line, "vv_dbw")),
            Is.EqualTo(10 * Math.Log10(power)).Within(0.35), "the tolerance, and 0.06 dB between cells");
    }

    [TestCase(2, "--antenna: needs --power W", "--antenna", "gaussian", "--beam", "2,8")]
    [TestCase(2, "--antenna gaussian: give --beam AZ,EL", "--range", "1000", "--power", "1", "--antenna", "gaussian")]
    [TestCase(2, "--antenna csc2: give --cosecant FROM,TO", "--range", "1000", "--power", "1", "--antenna", "csc2",
        "--beam", "2,8")]
    [TestCase(2, "--antenna sinc: it has no --cosecant", "--range", "1000", "--power", "1", "--antenna", "sinc",
        "--beam", "2,8", "--cosecant", "4,30")]
    [TestCase(2, "--cosecant -30,-5: the angles must lead away from 0 on one side, such as -5,-30", "--range", "1000",
        "--power", "1", "--antenna", "csc2", "--beam", "2,8", "--cosecant", "-30,-5")]
    [TestCase(2, "--cosecant -5,30: the angles must lead away", "--range", "1000", "--power", "1", "--antenna", "csc2",
        "--beam", "2,8", "--cosecant", "-5,30")]
    [TestCase(1, "--antenna plates: there is no such file; give one of gaussian, sinc, csc2, or a file with a table of a "
        + "pattern", "--range", "1000", "--power", "1", "--antenna", "plates")]
    [TestCase(1, "plate: the target is 2.87 degrees wide at --range 100, and all of it gets the gain of the phase "
        + "centre: it may take 0.2 degrees, a tenth of the beam; give a range of 1437 m or more", "--range", "100",
        "--power", "1", "--antenna", "gaussian", "--beam", "2,8")]
    public void Antenna_WithoutWhatItNeeds_IsRefusedBeforeAnyFile(int code, string message, params string[] options) =>
        AssertRefused(code, message, options);

    [Test]
    public void Table_ThatIsNone_IsAProblemOfAFile()
    {
        File.WriteAllText(At("pattern.csv"), "angle,gain\n");
        AssertRefused(1, $"--antenna {At("pattern.csv")}: an antenna's table must begin with the line "
            + "angle_deg,azimuth_db,elevation_db; give one of",
            ["--range", "1000", "--power", "1", "--antenna", At("pattern.csv")]);
    }

    // Facets of 3 degrees: at most 0.3 mm inside the sphere, a hundredth of the wavelength.
    static string Sphere()
    {
        const int around = 120, down = 60;
        var text = new StringBuilder();
        for (int i = 0; i <= down; i++)
            for (int j = 0; j < around; j++)
            {
                double polar = Math.PI * i / down, turn = 2 * Math.PI * j / around;
                text.Append(FormattableString.Invariant(
                    $"v {Radius * Math.Sin(polar) * Math.Cos(turn):r} {Radius * Math.Cos(polar):r} {Radius * Math.Sin(polar) * Math.Sin(turn):r}\n"));
            }
        for (int i = 0; i < down; i++)
            for (int j = 0; j < around; j++)
            {
                int a = i * around + j + 1, b = i * around + (j + 1) % around + 1;
                if (i < down - 1)
                    text.Append($"f {a} {b + around} {a + around}\n");
                if (i > 0)
                    text.Append($"f {a} {b} {b + around}\n");
            }
        return text.ToString();
    }
}
