using System.Collections.Generic;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>Setup of a sweep: radar, poses, and the objects that move.</summary>
    public sealed class SweepSetup
    {
        /// <param name="radar">The radar.</param>
        /// <param name="plan">The poses.</param>
        public SweepSetup(RadarController radar, SweepPlan plan) =>
            (Radar, Plan) = (radar, plan);

        /// <summary>The radar.</summary>
        public RadarController Radar { get; }

        /// <summary>The poses.</summary>
        public SweepPlan Plan { get; }

        /// <summary>
        /// The object that turns, from its current rotation, or about which the radar moves; may be null if the plan
        /// does neither.
        /// </summary>
        public Transform Target { get; set; }

        /// <summary>The sea whose snapshots are swept; may be null if the plan has none.</summary>
        public Sea Sea { get; set; }

        /// <summary>Orbit of the radar; null: that of RadarOrbit.About.</summary>
        public RadarOrbit Orbit { get; set; }

        /// <summary>Path of the scene or mesh file, for results.json; null for none.</summary>
        public string Scene { get; set; }

        /// <summary>The command line, for results.json; null if there is none.</summary>
        public IReadOnlyList<string> Command { get; set; }
    }
}
