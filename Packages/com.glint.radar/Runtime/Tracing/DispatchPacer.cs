using System;

namespace Glint
{
    /// <summary>
    /// Cuts long work into dispatches far below the two seconds of the operating system's watchdog. It starts small and
    /// follows the times of earlier dispatches.
    /// </summary>
    sealed class DispatchPacer
    {
        // Tiles times bounces of the first dispatch: the maximum of bounces is the only known measure of cost.
        const int FirstTileBounces = 4096;

        // Seconds. The limit is half a second; the next tiles may cost twice as much, or the machine may be busy.
        const double Target = 0.25;

        // Maximum growth of the number of tiles from one dispatch to the next, which may be in another part of the
        // picture.
        const int MaxGrowth = 4;

        // Decay of the maximum cost per dispatch.
        const double Memory = 0.8;

        int _bounces, _tiles, _dispatches;
        double _secondsPerTile;

        /// <summary>Forgets the times, for another kind of work.</summary>
        public void Reset() => _dispatches = 0;

        /// <summary>Number of tiles of the next dispatch, out of those left.</summary>
        /// <param name="bounces">Maximum number of bounces of a ray.</param>
        public int NextTiles(int left, int bounces)
        {
            if (bounces != _bounces)
                Reset();
            _bounces = bounces;
            double max = _dispatches == 0
                ? FirstTileBounces / bounces
                : Math.Min((double)MaxGrowth * _tiles, Target / _secondsPerTile);
            // In equal parts, so that the last one is not tiny.
            double parts = Math.Ceiling(left / Math.Max(1, max));
            return (int)Math.Ceiling(left / parts);
        }

        /// <summary>Records the time of a dispatch, including its read-back.</summary>
        public void Took(int tiles, double seconds)
        {
            double secondsPerTile = Math.Max(seconds / tiles, 1e-9);
            // The first dispatch also compiles the kernel.
            _secondsPerTile = _dispatches < 2 ? secondsPerTile : Math.Max(secondsPerTile, Memory * _secondsPerTile);
            _tiles = tiles;
            _dispatches = Math.Min(_dispatches + 1, 2);
        }
    }
}
