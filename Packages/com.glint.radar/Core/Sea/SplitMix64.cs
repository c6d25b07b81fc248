namespace Glint.Core
{
    /// <summary>
    /// The SplitMix64 generator (Steele, Lea and Flood 2014): integers only, so the same on every machine.
    /// </summary>
    struct SplitMix64
    {
        ulong _state;

        public SplitMix64(ulong seed) => _state = seed;

        public ulong Next()
        {
            _state += 0x9E3779B97F4A7C15;
            ulong mixed = _state;
            mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9;
            mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
            return mixed ^ (mixed >> 31);
        }

        /// <summary>Uniform in (0, 1], in steps of 2^-53.</summary>
        public double NextAboveZero() => ((Next() >> 11) + 1) * (1.0 / (1L << 53));
    }
}
