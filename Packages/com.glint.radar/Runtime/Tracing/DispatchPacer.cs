using System;

namespace Glint
{
    /// <summary>
    /// Cuts long work into dispatches far below the two seconds after which an operating system takes a GPU away.
    /// It starts small and goes by the time that the dispatches before took.
    /// </summary>
    sealed class DispatchPacer
    {
        // Tiles times bounces: how long a ray may be followed is all that is known at first.
        const int FirstTileBounces = 4096;

        // Seconds. Half a second is the most a dispatch may take;
        // the next tiles may be twice as costly, or the machine busy.
        const double Target = 0.25;

        // Of tiles, from one dispatch to the next: they may be of another part of the picture.
        const int MaxGrowth = 4;

        // The costliest dispatch counts, a little less with every one after it.
        const double Memory = 0.8;

        int _bounces, _tiles, _dispatches;
        double _secondsPerTile;

        /// <summary>Forgets the times: the work to come is of another kind.</summary>
        public void Reset() => _dispatches = 0;

        /// <summary>How many of the tiles left the next dispatch should take.</summary>
        /// <param name="bounces">Most bounces a ray may make.</param>
        public int NextTiles(int left, int bounces)
        {
            if (bounces != _bounces)
                Reset();
            _bounces = bounces;
            double max = _dispatches == 0
                ? FirstTileBounces / bounces
                : Math.Min((double)MaxGrowth * _tiles, Target / _secondsPerTile);
            // In even parts, so that the last one is no scrap.
            double parts = Math.Ceiling(left / Math.Max(1, max));
            return (int)Math.Ceiling(left / parts);
        }

        /// <summary>A dispatch of so many tiles took so long, its read-back included.</summary>
        public void Took(int tiles, double seconds)
        {
            double secondsPerTile = Math.Max(seconds / tiles, 1e-9);
            // The first one also compiled the kernel.
            _secondsPerTile = _dispatches < 2 ? secondsPerTile : Math.Max(secondsPerTile, Memory * _secondsPerTile);
            _tiles = tiles;
            _dispatches = Math.Min(_dispatches + 1, 2);
        }
    }
}
