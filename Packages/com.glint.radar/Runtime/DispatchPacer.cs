using System;

namespace Glint
{
    /// <summary>
    /// Cuts long work into dispatches far below the two seconds after which an operating system takes a GPU away. It starts small and goes by the time that the dispatches before took.
    /// </summary>
    sealed class DispatchPacer
    {
        const int FirstTiles = 2048;

        // Seconds. Half a second is the most a dispatch may take.
        const double Target = 0.3;

        double _secondsPerTile;

        /// <summary>Forgets the times: the work to come is of another kind.</summary>
        public void Reset() => _secondsPerTile = 0;

        /// <summary>How many of the tiles left the next dispatch should take.</summary>
        public int NextTiles(int left)
        {
            if (_secondsPerTile == 0)
                return Math.Min(left, FirstTiles);
            return (int)Math.Min(left, Math.Max(1, Target / _secondsPerTile));
        }

        /// <summary>A dispatch of so many tiles took so long, its read-back included.</summary>
        public void Took(int tiles, double seconds)
        {
            // The first one also compiled the kernel; few tiles do not fill a device.
            _secondsPerTile = Math.Max(seconds / tiles, 1e-9);
        }
    }
}
