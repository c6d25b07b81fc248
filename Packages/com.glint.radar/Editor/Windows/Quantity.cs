using System;
using System.Collections.Generic;

namespace Glint.Editor
{
    /// <summary>A quantity of a pose for charts.</summary>
    sealed class Quantity
    {
        public static readonly Quantity Normalised =
            new Quantity("Amplitude, normalised", true, pose => pose.Normalised, pose => pose.SamplingError);
        public static readonly Quantity Amplitude = new Quantity("Amplitude", true, pose => pose.Amplitude,
            pose => pose.Normalised > 0 ? pose.SamplingError * pose.Amplitude / pose.Normalised : 0);
        public static readonly Quantity RaysReceived =
            new Quantity("Rays received", false, pose => pose.RaysReceived, pose => 0);
        public static readonly Quantity RaysHit = new Quantity("Rays hit", false, pose => pose.RaysHit, pose => 0);

        readonly Func<PoseFigures, double> _value, _error;

        Quantity(string title, bool isAmplitude, Func<PoseFigures, double> value, Func<PoseFigures, double> error)
        {
            Title = title;
            IsAmplitude = isAmplitude;
            _value = value;
            _error = error;
        }

        public static IReadOnlyList<Quantity> All { get; } = new[] { Normalised, Amplitude, RaysReceived, RaysHit };

        public string Title { get; }

        /// <summary>Whether decibels apply.</summary>
        public bool IsAmplitude { get; }

        /// <summary>The value, at least 0.</summary>
        public double Of(PoseFigures pose) => _value(pose);

        /// <summary>Sampling error to either side; 0 for none.</summary>
        public double ErrorOf(PoseFigures pose) => _error(pose);
    }
}
