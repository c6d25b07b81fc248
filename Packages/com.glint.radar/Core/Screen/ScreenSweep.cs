using System;

namespace Glint.Core
{
    /// <summary>
    /// Which spokes a frame traces, and which it finishes. Spokes are counted from the first turn on. Those under the
    /// leading edge of the beam are traced, so that a spoke has all its echoes when the middle of the beam has passed
    /// it.
    /// </summary>
    public sealed class ScreenSweep
    {
        readonly int _halfBeam, _spokes;
        bool _hasStarted;

        /// <summary>A sweep that begins where the antenna is at the first frame.</summary>
        public ScreenSweep(ScreenGeometry geometry) =>
            (_halfBeam, _spokes) = (geometry.HalfBeam, geometry.Radar.Spokes);

        /// <summary>The most spokes of a frame: half a turn. Later frames finish what remains.</summary>
        public int MaxSpokes => _spokes / 2;

        /// <summary>The next spoke to trace.</summary>
        public long Traced { get; private set; }

        /// <summary>The next spoke to finish.</summary>
        public long Finished { get; private set; }

        /// <summary>Moves the antenna.</summary>
        /// <param name="turns">Its bearing in turns from north, counted on.</param>
        public ScreenSlice Advance(double turns)
        {
            long target = (long)Math.Floor(turns * _spokes);
            if (!_hasStarted)
                (Traced, Finished, _hasStarted) = (target - _halfBeam, target, true);
            var slice = new ScreenSlice { FirstTraced = Traced, FirstFinished = Finished };
            Finished = Math.Max(Finished, Math.Min(target, Finished + MaxSpokes));
            Traced = Finished + _halfBeam;
            slice.Traced = (int)(Traced - slice.FirstTraced);
            slice.Finished = (int)(Finished - slice.FirstFinished);
            return slice;
        }
    }

    /// <summary>The spokes of a frame.</summary>
    public struct ScreenSlice
    {
        /// <summary>First spoke to trace.</summary>
        public long FirstTraced;

        /// <summary>Number of spokes to trace.</summary>
        public int Traced;

        /// <summary>First spoke to finish.</summary>
        public long FirstFinished;

        /// <summary>Number of spokes to finish.</summary>
        public int Finished;
    }
}
