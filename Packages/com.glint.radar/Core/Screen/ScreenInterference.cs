using System;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Pulses of other radars among the echoes of a radar screen. A spoke has one sweep; it shows each pulse that comes in
    /// it at half of the way that light goes since the screen's own pulse. The other radar has the antenna and the pulse
    /// length of the screen. Immutable.
    /// </summary>
    public sealed class ScreenInterference
    {
        readonly ScreenGeometry _geometry;
        readonly double _secondsOfSpoke, _secondsOfCell, _fieldAtOne;

        /// <summary>The interference of a screen.</summary>
        public ScreenInterference(ScreenGeometry geometry)
        {
            var radar = geometry.Radar;
            _geometry = geometry;
            _secondsOfSpoke = 60 / radar.TurnsAMinute / radar.Spokes;
            _secondsOfCell = 2 * geometry.CellSize / Signal.SpeedOfLight;
            // Friis: the root of one watt at one metre, over that of the noise.
            _fieldAtOne = Signal.Wavelength(radar.Frequency) / (4 * Math.PI)
                * Math.Sqrt(PowerLevel.FromDecibels(-radar.LossDb) / geometry.NoisePower);
        }

        /// <summary>
        /// The pulses of another radar in a spoke: GLINT_FOREIGN_PULSES in Shaders/ScreenReceiver.hlsl. Cell in which the
        /// first one comes, counted from the start of the sweep; cells between them; field over the root of the noise's
        /// power; 0.
        /// </summary>
        /// <param name="spoke">Counted from north in the first turn.</param>
        public float4 PulsesOf(long spoke, in OtherRadar other)
        {
            double time = spoke * _secondsOfSpoke, rate = _geometry.Radar.PulseRate,
                range = math.length(other.Offset), sent = rate > 0 ? Math.Floor(time * rate) / rate : time,
                delay = range / Signal.SpeedOfLight,
                next = Math.Ceiling((sent - delay) * other.PulseRate) / other.PulseRate + delay;
            return (float4)new double4((next - sent) / _secondsOfCell, 1 / (other.PulseRate * _secondsOfCell),
                FieldOf(time, spoke, range, other), 0);
        }

        double FieldOf(double time, long spoke, double range, in OtherRadar other)
        {
            double distance = math.length(other.Offset.xz);
            if (!(range > 0) || ScreenGeometry.IsBehindHorizon(other.AntennaHeight, other.AntennaHeight + other.Offset.y,
                distance))
                return 0;
            double bearing = Math.Atan2(other.Offset.x, other.Offset.z), drop = ClutterGeometry.DropAt(distance),
                beam = 2 * Math.PI * _geometry.InTurn(spoke) / _geometry.Radar.Spokes,
                otherBeam = 2 * Math.PI * (other.StartTurns + time * other.TurnsAMinute / 60);
            var antenna = _geometry.Antenna;
            // Each is lower by the drop in the other's horizontal plane.
            var gain = antenna.Field(bearing - beam, Math.Atan2(other.Offset.y - drop, distance))
                * antenna.Field(bearing + Math.PI - otherBeam, Math.Atan2(-other.Offset.y - drop, distance));
            return _fieldAtOne * Math.Sqrt(other.Power) / range * Math.Exp(-_geometry.RainLoss * range) * gain.Magnitude;
        }
    }

    /// <summary>A radar whose pulses a screen receives.</summary>
    public struct OtherRadar
    {
        /// <summary>From the screen's antenna, metres: x to the east, y up, z to the north.</summary>
        public double3 Offset;

        /// <summary>Of the screen's antenna above the sea, metres.</summary>
        public double AntennaHeight;

        /// <summary>Peak power in the screen's bandwidth, watts.</summary>
        public double Power;

        /// <summary>Pulses a second.</summary>
        public double PulseRate;

        /// <summary>Turns of its antenna a minute.</summary>
        public double TurnsAMinute;

        /// <summary>True bearing of its antenna when the screen's own passed north for the first time, turns.</summary>
        public double StartTurns;
    }
}
