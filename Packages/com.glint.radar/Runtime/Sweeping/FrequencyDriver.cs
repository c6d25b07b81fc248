using Glint.Core;

namespace Glint
{
    /// <summary>Sets the radar's carrier frequency.</summary>
    sealed class FrequencyDriver : AxisDriver
    {
        readonly RadarController _radar;
        readonly double _frequencyHz;

        public FrequencyDriver(RadarController radar)
        {
            _radar = radar;
            _frequencyHz = radar.Settings.FrequencyHz;
        }

        internal override void Show(SweepPose pose) => Set(pose[SweepAxis.Frequency].Value);

        internal override void PutBack()
        {
            if (_radar != null)
                Set(_frequencyHz);
        }

        void Set(double frequencyHz)
        {
            var settings = _radar.Settings;
            settings.FrequencyHz = frequencyHz;
            _radar.Settings = settings;
        }
    }
}
