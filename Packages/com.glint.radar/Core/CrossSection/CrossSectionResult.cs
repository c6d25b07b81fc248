using System;
using System.Collections.Generic;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>The cross section of a pose.</summary>
    public sealed class CrossSectionResult
    {
        /// <summary>Receivers times samples, which are frequencies of a pulse.</summary>
        public CrossSectionResult(int receivers, int samples)
        {
            S = new ScatteringMatrix[receivers, samples];
            Sea = new ScatteringMatrix[receivers, samples];
            Clutter = new ClutterEcho[samples];
            ShipSea = new ClutterEcho[samples];
            Errors = new double[receivers, samples];
            CrossErrors = new double[receivers, samples];
        }

        /// <summary>
        /// Scattering matrix of each receiver and <see cref="CrossSectionPose.SampleOf">sample</see>, metres.
        /// </summary>
        public ScatteringMatrix[,] S { get; }

        /// <summary>
        /// The part of <see cref="S"/> of paths that met nothing but seas with a diffuse echo, and of that echo: 0
        /// without such a sea.
        /// </summary>
        public ScatteringMatrix[,] Sea { get; }

        /// <summary>Diffuse echo of the seas at each sample: included in <see cref="Sea"/>.</summary>
        public ClutterEcho[] Clutter { get; }

        /// <summary>
        /// Diffuse echo that the seas and all else make together at each sample: included in <see cref="S"/>, and not in
        /// <see cref="Sea"/>.
        /// </summary>
        public ClutterEcho[] ShipSea { get; }

        /// <summary>Standard error of the integration, of the complex amplitudes of VV and HH, metres.</summary>
        public double[,] Errors { get; }

        /// <summary>The same of HV and VH.</summary>
        public double[,] CrossErrors { get; }

        /// <summary>The errors of some polarisations beside their amplitudes.</summary>
        public CrossSectionAccuracy AccuracyOf(IReadOnlyList<Polarisation> polarisations, int receiver, int sample) =>
            new CrossSectionAccuracy(polarisations, S[receiver, sample], Errors[receiver, sample],
                CrossErrors[receiver, sample], FloorDbsm);

        /// <summary>
        /// The floor of the tolerance, dBsm: that of the pose, or the clutter of its seas if that is more.
        /// </summary>
        public double FloorDbsm { get; set; }

        /// <summary>Whether every amplitude has the error asked for.</summary>
        public bool IsMet { get; set; }

        /// <summary>Pieces of tubes summed: one for each bounce and receiver.</summary>
        public long Tubes { get; set; }

        /// <summary>Most bounces of a tube; 0 if only edges return.</summary>
        public int Bounces { get; set; }

        /// <summary>Edges without fringe fields because a face is no perfect conductor; 0 without edges.</summary>
        public int WedgesLeftOut { get; set; }

        /// <summary>
        /// Errors that a cell was allowed in VV and HH, and in HV and VH, in each attempt, as fractions of what a conducting plate
        /// of a base cell returns: with them the tracer finds the same tubes again.
        /// </summary>
        public IReadOnlyList<(double CellError, double CrossCellError)> Attempts { get; set; }

        /// <summary>Adds the diffuse echo of seas at each sample, which returns to the only receiver.</summary>
        /// <param name="clutter">Null: none.</param>
        /// <param name="shipSea">That which they make with all else; null: none.</param>
        public void Add(ClutterEcho[] clutter, ClutterEcho[] shipSea)
        {
            for (int sample = 0; shipSea != null && sample < shipSea.Length; sample++)
            {
                ShipSea[sample] = shipSea[sample];
                S[0, sample] += shipSea[sample].S;
            }
            for (int sample = 0; clutter != null && sample < clutter.Length; sample++)
            {
                Clutter[sample] = clutter[sample];
                Sea[0, sample] += clutter[sample].S;
                S[0, sample] += clutter[sample].S;
            }
        }

        /// <summary>Rays traced, those that only look for borders included.</summary>
        public long Rays { get; set; }
    }

    /// <summary>The error of a scattering matrix beside its amplitudes.</summary>
    public readonly struct CrossSectionAccuracy
    {
        /// <summary>Standard errors that a tolerance must hold: 95 % of complex amplitudes are within.</summary>
        public const double Confidence = 1.75;

        readonly double _relativeError;

        /// <summary>The largest error of some elements of a matrix, each beside its own amplitude.</summary>
        /// <param name="polarisations">The elements.</param>
        /// <param name="s">The matrix, metres.</param>
        /// <param name="error">Standard error of VV and HH, metres.</param>
        /// <param name="crossError">The same of HV and VH.</param>
        /// <param name="floorDbsm">The floor, which replaces amplitudes below it.</param>
        public CrossSectionAccuracy(IReadOnlyList<Polarisation> polarisations, in ScatteringMatrix s, double error,
            double crossError, double floorDbsm)
        {
            _relativeError = 0;
            foreach (var polarisation in polarisations)
                _relativeError = Math.Max(_relativeError,
                    (polarisation.IsCross ? crossError : error) / ScaleOf(polarisation.Of(s), floorDbsm));
        }

        /// <summary>What an error is relative to: the amplitude, or the floor if that is larger, metres.</summary>
        public static double ScaleOf(Complex amplitude, double floorDbsm) =>
            Math.Max(Math.Pow(10, floorDbsm / 20), amplitude.Magnitude);

        /// <summary>The largest standard error, decibels.</summary>
        public double ErrorDb => 20 * Math.Log10(1 + _relativeError);

        /// <summary>Ratio of the error, which 95 % of amplitudes do not exceed, to that of a tolerance.</summary>
        public double Excess(double toleranceDb) =>
            Confidence * _relativeError / AllowedBy(toleranceDb);

        /// <summary>Relative error that a tolerance allows.</summary>
        public static double AllowedBy(double toleranceDb) => Math.Pow(10, toleranceDb / 20) - 1;
    }
}
