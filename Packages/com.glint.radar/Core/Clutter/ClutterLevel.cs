using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Where the mean of a sea's diffuse echo comes from.</summary>
    public enum ClutterLevel
    {
        /// <summary>The waves: nothing is scaled.</summary>
        Physics,

        /// <summary>The model of that name in <see cref="ClutterModel.All"/>.</summary>
        Nrl,

        /// <inheritdoc cref="Nrl"/>
        Git,

        /// <summary><see cref="NathansonTable"/>.</summary>
        Nathanson
    }

    /// <summary>
    /// Factors that bring the mean diffuse echo of a sea to that of a published model, over the grazing angle, at one
    /// frequency and direction. Texture, speckle and motion stay. Immutable.
    /// </summary>
    public sealed class ClutterLevelTable
    {
        // Dense where the echo is steep: of few lit crests, and of mirror points.
        static readonly double[] s_grazing =
            { 0.1, 0.2, 0.3, 0.5, 0.7, 1, 2, 3, 5, 7, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60 };

        readonly float4[] _values;

        /// <summary>The factors from an echo to a model.</summary>
        /// <param name="grazingDegrees">Those of <see cref="AnglesOf"/>.</param>
        /// <param name="own">Mean echo of the sea at these.</param>
        /// <param name="conditions">Radar and sea at a grazing angle in degrees.</param>
        /// <exception cref="GlintException">The sea has no echo at an angle.</exception>
        public ClutterLevelTable(ClutterModel model, IReadOnlyList<double> grazingDegrees, IReadOnlyList<Sigma0> own,
            Func<double, ClutterConditions> conditions)
        {
            _values = grazingDegrees.Select((degrees, i) =>
            {
                if (!(own[i].VV > 0 && own[i].HH > 0))
                    throw new GlintException($"clutter model {model.Name}: the sea has no echo of its own at "
                        + $"{Medium.Number(degrees)} deg, which could be scaled: use a larger or finer tile, or physics");
                var at = conditions(degrees);
                double Factor(Polarisation polarisation, double sigma) =>
                    Math.Log(10) / 10 * model.Decibels(polarisation, at) - Math.Log(sigma);
                double vv = Factor(Polarisation.VV, own[i].VV), hh = Factor(Polarisation.HH, own[i].HH);
                return (float4)new double4(vv, (vv + hh) / 2, hh, Math.Log(Math.Sin(math.radians(degrees))));
            }).ToArray();
        }

        /// <summary>
        /// For a kernel: natural logarithms of the factors of the power of VV, HV and HH, then that of the sine of the
        /// grazing angle, which ascends. HV has the geometric mean of the others, as no model has it. They are linear
        /// between the angles, and constant outside.
        /// </summary>
        public IReadOnlyList<float4> Values => _values;

        /// <summary>Angles in degrees of a table: those of a fixed list at which the model holds.</summary>
        /// <exception cref="GlintException">It holds at none; the message is that at 10 degrees.</exception>
        public static IReadOnlyList<double> AnglesOf(ClutterModel model, Func<double, ClutterConditions> conditions)
        {
            var angles = s_grazing.Where(degrees => model.Holds(conditions(degrees))).ToArray();
            if (angles.Length == 0)
                model.Require(conditions(10));
            return angles;
        }

        /// <summary>Factors of the power at a grazing angle.</summary>
        /// <param name="grazing">rad.</param>
        public Sigma0 FactorAt(double grazing)
        {
            double place = Math.Log(Math.Sin(grazing));
            int next = Array.FindIndex(_values, value => value.w > place);
            double4 at = next == 0 || _values.Length == 1 ? _values[0] : next < 0 ? _values[_values.Length - 1]
                : math.lerp(_values[next - 1], (double4)_values[next],
                    (place - _values[next - 1].w) / (_values[next].w - _values[next - 1].w));
            return new Sigma0(Math.Exp(at.z), Math.Exp(at.x), Math.Exp(at.y));
        }
    }
}
