using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Glint.Core;

namespace Glint.Tests
{
    /// <summary>Rows of cross sections that were not computed.</summary>
    static class SampleRows
    {
        /// <summary>A row for each azimuth at elevation 0 and 10 GHz, of VV and HH.</summary>
        /// <param name="vv">VV in dBsm; minus infinity for none.</param>
        /// <param name="hh">HH.</param>
        public static IReadOnlyList<CrossSectionRow> Of(double[] azimuths, Func<double, double> vv,
            Func<double, double> hh, string polarisations = "vv,hh") =>
            Of(new CrossSectionPlan(azimuths, new double[] { 0 }, new[] { 10e9 }), vv, hh, polarisations);

        /// <summary>A row for each of a plan.</summary>
        public static IReadOnlyList<CrossSectionRow> Of(CrossSectionPlan plan, Func<double, double> vv,
            Func<double, double> hh, string polarisations = "vv,hh") =>
            Enumerable.Range(0, plan.Count).Select(i => new CrossSectionRow(plan[i], new ScatteringMatrix
            {
                VV = Amplitude(vv(plan[i].AzimuthDegrees)), HH = -Amplitude(hh(plan[i].AzimuthDegrees))
            }, Polarisation.Read(polarisations))).ToArray();

        static Complex Amplitude(double dbsm) => Math.Pow(10, dbsm / 20);
    }
}
