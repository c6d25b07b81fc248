using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// Statistics of sea clutter. K-distributed intensity is speckle times texture, and the shape is the squared mean
    /// of the texture over its variance: small where there are spikes.
    /// </summary>
    public static class ClutterStatistics
    {
        /// <summary>Largest grazing angle in degrees of <see cref="EmpiricalShape"/>.</summary>
        public const double MaxGrazingOfShape = 10;

        /// <summary>Frequencies of <see cref="EmpiricalShape"/>, Hz: X band.</summary>
        public static readonly Interval FrequenciesOfShape = Interval.Closed(8e9, 12e9);

        static readonly Interval s_grazing = Interval.Closed(0.1, MaxGrazingOfShape);

        /// <summary>
        /// Shape measured at X band (Ward, Baker and Watts 1990).
        /// </summary>
        /// <param name="grazingDegrees">0.1 to 10 deg.</param>
        /// <param name="area">Of a cell on the sea, m2.</param>
        /// <param name="isHorizontal">HH, not VV.</param>
        /// <param name="swellAngleDegrees">
        /// From the swell's direction to that of the radar. 45 without swell.
        /// </param>
        /// <exception cref="GlintException">An angle or the area is out of range.</exception>
        public static double EmpiricalShape(double grazingDegrees, double area, bool isHorizontal,
            double swellAngleDegrees)
        {
            if (!s_grazing.Contains(grazingDegrees))
                throw new GlintException($"sea clutter: the grazing angle {Medium.Number(grazingDegrees)} deg must be "
                    + $"{s_grazing} deg for the measured shape of the K-distribution");
            if (!(area > 0))
                throw new GlintException($"sea clutter: the area {Medium.Number(area)} m2 of a cell must be above 0");
            double logarithm = 2.0 / 3 * Math.Log10(grazingDegrees) + 5.0 / 8 * Math.Log10(area)
                - (isHorizontal ? 2.09 : 1.39) - Math.Cos(swellAngleDegrees * Math.PI / 90) / 3;
            return Math.Pow(10, logarithm);
        }

        /// <summary>Shape of textures, which are intensities without speckle.</summary>
        public static double ShapeOfTexture(IReadOnlyCollection<double> textures)
        {
            double mean = textures.Average();
            return mean * mean / textures.Average(texture => (texture - mean) * (texture - mean));
        }

        /// <summary>
        /// Shape of intensities of one look, by their logarithms: a lower variance than by their squares. Infinite
        /// where they are no spikier than exponential ones.
        /// </summary>
        public static double ShapeOfIntensity(IReadOnlyCollection<double> intensities)
        {
            double mean = intensities.Average();
            double inverse = intensities.Average(z => z * Math.Log(z)) / mean - intensities.Average(Math.Log) - 1;
            return inverse > 0 ? 1 / inverse : double.PositiveInfinity;
        }

        /// <summary>Correlation length in metres of the texture in range (Watts).</summary>
        /// <param name="wind">m/s.</param>
        /// <param name="windAngleDegrees">From the wind's direction to that of the radar.</param>
        public static double TextureLength(double wind, double windAngleDegrees)
        {
            double cosine = Math.Cos(windAngleDegrees * Math.PI / 180);
            return Math.PI / 2 * wind * wind / SeaSpectrum.Gravity * Math.Sqrt(3 * cosine * cosine + 1);
        }
    }

    /// <summary>What the radar sees of the sea at low grazing angles.</summary>
    public static class ClutterGeometry
    {
        /// <summary>Radius in metres of an earth with straight rays: four thirds of the true one, 6,371 km.</summary>
        public const double EarthRadius = 4.0 / 3 * 6371000;

        /// <summary>By how much the mean level of the sea lies lower at a distance, metres.</summary>
        public static double DropAt(double distance) => distance * distance / (2 * EarthRadius);

        /// <summary>
        /// Fraction of a Gaussian surface that a radar sees (Smith 1967), within 2 to 5 % of traced surfaces.
        /// </summary>
        /// <param name="grazing">rad, above 0.</param>
        /// <param name="slope">Standard deviation of the slope in the direction of the radar, above 0.</param>
        public static double LitFraction(double grazing, double slope)
        {
            double v = Math.Tan(grazing) / (Math.Sqrt(2) * slope);
            double lambda = 0.5 * (Math.Exp(-v * v) / (v * Math.Sqrt(Math.PI)) - ErrorFunction.Erfc(v));
            return (1 - 0.5 * ErrorFunction.Erfc(v)) / (1 + lambda);
        }

        /// <summary>
        /// Grazing angle in rad at a point of the curved sea; below 0 behind the horizon, where the direct ray does not
        /// come.
        /// </summary>
        /// <param name="height">Of the radar above the sea, m.</param>
        /// <param name="range">From the radar to the point, m, not below the height.</param>
        public static double Grazing(double height, double range) => Math.Asin(Math.Min(1, height / range
            + height * height / (2 * EarthRadius * range) - range / (2 * EarthRadius)));
    }
}
