using System.Collections.Generic;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>What a sweep is of: who traces, which poses, and what is moved for them.</summary>
    public sealed class SweepSetup
    {
        /// <param name="radar">Traces the poses.</param>
        /// <param name="plan">The poses.</param>
        public SweepSetup(RadarController radar, SweepPlan plan) =>
            (Radar, Plan) = (radar, plan);

        /// <summary>Traces the poses.</summary>
        public RadarController Radar { get; }

        /// <summary>The poses.</summary>
        public SweepPlan Plan { get; }

        /// <summary>
        /// What is turned, from its rotation now, or what the radar is moved about;
        /// may be null when the plan does neither.
        /// </summary>
        public Transform Target { get; set; }

        /// <summary>Whose snapshots are shown; may be null when the plan has none.</summary>
        public Sea Sea { get; set; }

        /// <summary>Moves the radar; null: about the target, as RadarOrbit.About says.</summary>
        public RadarOrbit Orbit { get; set; }

        /// <summary>Path of the scene or mesh file, for results.json; null for none.</summary>
        public string Scene { get; set; }

        /// <summary>The command line that asks for it, for results.json; null when none does.</summary>
        public IReadOnlyList<string> Command { get; set; }
    }
}
