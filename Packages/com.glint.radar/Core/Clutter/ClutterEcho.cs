using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>The diffuse echo of a sea, or of a cell of it.</summary>
    public struct ClutterEcho
    {
        /// <summary>Field with speckle, metres: of one moment, and random in phase.</summary>
        public ScatteringMatrix S;

        /// <summary>Mean cross section over the speckle, square metres.</summary>
        public double SigmaVV, SigmaHV, SigmaHH;

        /// <summary>Horizontal area of the facets in square metres: all, and those that the radar sees.</summary>
        public double Area, LitArea;

        /// <summary>Facets whose centres the radar sees, as a fraction of the area; NaN without facets.</summary>
        public double LitFraction => LitArea / Area;

        /// <summary>Mean cross section per area of the mean sea; NaN without facets.</summary>
        public Sigma0 Sigma0 => new Sigma0(SigmaHH / Area, SigmaVV / Area, SigmaHV / Area);

        /// <summary>Mean cross section of a polarisation over the speckle, square metres.</summary>
        public double SigmaOf(Polarisation polarisation) => polarisation.Of(new ScatteringMatrix
        {
            VV = SigmaVV, HV = SigmaHV, VH = SigmaHV, HH = SigmaHH
        }).Real;

        /// <summary>Echo of two parts.</summary>
        public static ClutterEcho operator +(in ClutterEcho a, in ClutterEcho b) => new ClutterEcho
        {
            S = a.S + b.S, SigmaVV = a.SigmaVV + b.SigmaVV, SigmaHV = a.SigmaHV + b.SigmaHV,
            SigmaHH = a.SigmaHH + b.SigmaHH, Area = a.Area + b.Area, LitArea = a.LitArea + b.LitArea
        };

        /// <summary>Echo of all parts.</summary>
        public static ClutterEcho Sum(IEnumerable<ClutterEcho> parts)
        {
            var sum = default(ClutterEcho);
            foreach (var part in parts)
                sum += part;
            return sum;
        }
    }
}
