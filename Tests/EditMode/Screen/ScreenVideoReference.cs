using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>The receiver behind the levels, in double precision, from the page's formulas.</summary>
    sealed class ScreenVideoReference
    {
        const int ClutterCells = 16;

        readonly ScreenGeometry _geometry;
        readonly ScreenReceiver _receiver;

        public ScreenVideoReference(ScreenGeometry geometry, in ScreenReceiver receiver)
        {
            (_geometry, _receiver) = (geometry, receiver);
            Video = new double2[geometry.Radar.Spokes * geometry.Radar.Cells];
        }

        /// <summary>Video of a turn with persistence, and without.</summary>
        public double2[] Video { get; }

        public void Finish(float[] levels, int first, int count)
        {
            int cells = _geometry.Radar.Cells, pulse = _geometry.Pulse.Length;
            for (int spoke = first; spoke < first + count; spoke++)
            {
                double[] controlled = levels.Skip(spoke * cells).Take(cells).Select((level, cell) =>
                {
                    double share = (cell + 0.5) * _geometry.CellSize / _receiver.SensitivityTimeRange;
                    return level + 10 * Math.Log10(Math.Min(1, share * share * share));
                }).ToArray();
                for (int cell = 0; cell < cells; cell++)
                {
                    var around = Enumerable.Range(pulse + 1, ClutterCells).SelectMany(i => new[] { cell - i, cell + i })
                        .Where(at => at >= 0 && at < cells).ToArray();
                    double level = controlled[cell]
                        - _receiver.RainFilter * Math.Max(0, cell >= pulse ? controlled[cell - pulse] : 0)
                        - _receiver.ClutterFilter * Math.Max(0, around.Average(at => controlled[at]));
                    double video = Math.Max(0, Math.Min(1, (level + _receiver.GainDb) / _receiver.DynamicRangeDb));
                    double old = Video[spoke * cells + cell].x;
                    Video[spoke * cells + cell] = new double2(
                        Math.Max(video, old * Math.Exp(-1 / _receiver.PersistenceTurns)), video);
                }
            }
        }
    }
}
