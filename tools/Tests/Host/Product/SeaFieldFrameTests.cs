using System;
using System.Linq;
using Glint.Core;
using Glint.Tests;
using NUnit.Framework;
using Unity.Mathematics;

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
        // Lists of the host grow in the first frames.
        for (int frame = 0; frame < 16; frame++)
            BytesOfFrame(field, frame);
        Assert.That(Enumerable.Range(16, 16).Select(frame => BytesOfFrame(field, frame)), Is.All.Zero);
        Assert.That(field.Uploads, Is.EqualTo(1));
    }

    static long BytesOfFrame(SeaField field, int frame)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        field.Update(frame / 60.0);
        long bytes = GC.GetAllocatedBytesForCurrentThread() - before;
        // The end of a frame.
        field.Bounds.ReadBack(new float2[1], 1);
        return bytes;
    }
}
