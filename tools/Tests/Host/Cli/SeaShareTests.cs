using System.Linq;
using Glint.Cli;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>Pixel and length distinguish rays of the ship alone from rays that met the sea.</summary>
public sealed class SeaShareTests
{
    [Test]
    public void Of_RaysThatStayThatAreLostAndThatAreNew_CountsEachAndSumsThoseOfTheShip()
    {
        var freeSpace = Sweep(Ray(1, 100, 3, 0, 2), Ray(2, 101, 0, 4, 2), Ray(3, 102, 9, 9, 1));
        // Pixel 3 is hidden; pixel 2 has a different return, and pixel 8 a new one.
        var onSea = Sweep(Ray(1, 100 + 1e-6, 3, 0, 2), Ray(2, 99, 1, 1, 3), Ray(8, 100, 1, 1, 1));

        var share = SeaShare.Of(freeSpace, onSea).Single();

        Assert.That((share.Unchanged, share.Lost), Is.EqualTo((1, 2)));
        Assert.That(share.ShipAlone, Is.EqualTo(3));
        Assert.That(share.Added, Is.EqualTo(new[] { 1, 0, 1, 0 }));
        Assert.That((share.Step, share.FreeSpace, share.OnSea), Is.EqualTo((30.0, 5.0, 5.0)));
    }

    [Test]
    public void Table_OfShares_HasARowAnAngle()
    {
        string table = ExperimentTables.Of([new SeaShare(15, 10, 12.5, 10, 100, 1, [0, 20, 30, 4])]);
        Assert.That(table.Split('\n')[2],
            Is.EqualTo("| 15 | 10.00 | 12.50 | 10.00 | 100 | 1 | 54 | 0 | 20 | 30 | 4 |"));
    }

    // The amplitude of a pose is made up: 5.
    static SweepResult Sweep(params RayData[] rays) => new(Experiment.ShipInFreeSpace, null,
        [new SweepRow(new SweepPose(30), new RadarResult(new RadarSums { InPhase = 3, Quadrature = 4 }, null, rays))]);

    static RayData Ray(uint pixel, double length, float inPhase, float quadrature, uint bounces) => new()
    {
        Pixel = pixel, PathLength = (float)length, PathLengthLo = (float)(length - (float)length),
        InPhase = inPhase, Quadrature = quadrature, Bounces = bounces,
        IsReceived = inPhase != 0 || quadrature != 0
    };
}
