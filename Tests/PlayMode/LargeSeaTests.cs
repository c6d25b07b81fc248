using System.Collections;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Glint.Tests
{
    /// <summary>The ship on a sea of 2 x 2 km, a thousand instances of one tile.</summary>
    [Category("Slow")]
    public sealed class LargeSeaTests
    {
        [UnityTest]
        [Timeout(600000)]
        public IEnumerator ShipLargeSea_TensOfMillionsOfTriangles_TakesTheMemoryOfOneTile()
        {
            yield return PlayScene.Load("ShipLargeSea", PlayScene.TraceAQuarter);
            var radar = Object.FindFirstObjectByType<RadarController>();
            var sea = Object.FindFirstObjectByType<Sea>();

            Assert.That(sea.GetComponentsInChildren<MeshRenderer>().Select(tile => tile.forceRenderingOff),
                Has.All.True, "33 million triangles in every repaint");

            var large = Trace(radar);
            Assert.That(large.Statistics.Triangles, Is.GreaterThan(30_000_000));
            Assert.That(large.RaysEmitted, Is.EqualTo(960 * 540));

            sea.Extent = new Vector2(64, 64);
            sea.Rebuild();
            var small = Trace(radar);
            Assert.That(small.Statistics.Triangles, Is.LessThan(100_000));
            Assert.That(small.RaysHit, Is.LessThan(large.RaysHit));
            Assert.That(large.Statistics.BytesOnDevice, Is.LessThan(1.1 * small.Statistics.BytesOnDevice));
        }

        // A pose in a second tracer, since buffers grow with the tiles of a dispatch, which depend on its time.
        static RadarResult Trace(RadarController radar)
        {
            using (var tracer = new RayTracer(radar.Kernel) { TilesADispatch = 4096 })
                return tracer.Trace(radar.Gather(), RayReadback.None);
        }
    }
}
