using System;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The video of a radar screen as ASTERIX messages of category 240, one a spoke.</summary>
    public sealed class ScreenAsterix
    {
        readonly ScreenGeometry _geometry;
        readonly AsterixVideo _encoder;
        readonly byte[] _cells;

        /// <exception cref="GlintException">The cells are longer than the format allows.</exception>
        public ScreenAsterix(ScreenGeometry geometry, byte areaCode = 0, byte identificationCode = 1)
        {
            _geometry = geometry;
            _encoder = new AsterixVideo(areaCode, identificationCode, geometry.CellSize);
            _cells = new byte[geometry.Radar.Cells];
        }

        /// <summary>The message of a spoke: its video with persistence, in 8 bits.</summary>
        /// <param name="spoke">Counted from north or from the first turn.</param>
        /// <param name="video">
        /// Video of spokes, with persistence and without, the first of which begins at <paramref name="first"/>.
        /// </param>
        /// <param name="secondsOfDay">Time after midnight UTC.</param>
        public byte[] Encode(long spoke, float2[] video, int first, double secondsOfDay)
        {
            for (int cell = 0; cell < _cells.Length; cell++)
                _cells[cell] = (byte)Math.Round(255 * video[first + cell].x);
            double degrees = 360.0 / _geometry.Radar.Spokes,
                middle = _geometry.InTurn(spoke) * degrees;
            return _encoder.Encode(middle - degrees / 2, middle + degrees / 2, 0, _cells, secondsOfDay);
        }
    }
}
