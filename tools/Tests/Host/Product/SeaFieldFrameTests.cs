using System;
using Glint.Core;
using Glint.Tests;
using NUnit.Framework;

namespace Glint.Host.Tests.Product;

/// <summary>A frame of a sea's field leaves nothing to the garbage collector.</summary>
public sealed class SeaFieldFrameTests
{
    [Test]
    public void Update_WithoutUpload_AllocatesNothing()
    {
        var settings = SeaSettings.Default;
        settings.TileSize = 256;
        var tile = new SeaSurface(settings);
        using var field = new SeaField(TestKernels.SeaField, "test", tile, tile.Finer(32));
        field.Update(0);
        field.Update(1);
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 10; i++)
            field.Update(2 + i / 60.0);
        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
        Assert.That(field.Uploads, Is.EqualTo(1));
    }
}
