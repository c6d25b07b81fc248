using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Editor
{
    /// <summary>Checks a Sweep as it would begin in play mode.</summary>
    sealed class SweepCheck
    {
        readonly Sweep _sweep;
        readonly List<Finding> _findings = new List<Finding>();

        public SweepCheck(Sweep sweep) => _sweep = sweep;

        public IReadOnlyList<Finding> Findings => _findings;

        /// <summary>The poses; null if the lists are invalid.</summary>
        public SweepPlan Plan { get; private set; }

        /// <summary>Updates the findings.</summary>
        public void Update()
        {
            _findings.Clear();
            Plan = null;
            if (!_sweep.isActiveAndEnabled)
                _findings.Add(new Finding(Severity.Warning, SceneSearch.IsDisabled(_sweep)));
            if (_sweep.Radar == null)
                Finding.Add(_findings, () => SceneSearch.FindRadar(_sweep.Searcher), FindRadar);
            Finding.Add(_findings, CheckPoses);
        }

        /// <summary>The figures for an inspector: label, value, meaning.</summary>
        public IEnumerable<(string label, string value, string tooltip)> Rows()
        {
            if (Plan != null)
                yield return ("Poses", FormattableString.Invariant($"{Plan.Count:N0}"),
                    "Every value of each list with every value of the others.");
        }

        void CheckPoses()
        {
            Plan = _sweep.Plan();
            if (!(_sweep.FindSea() is Sea sea))
                return;
            foreach (double number in Plan.Values(SweepAxis.Snapshot))
                sea.CheckSnapshot((int)number);
        }

        // The first of several enabled radars; a new one if there is none.
        Fix FindRadar()
        {
            var all =
                Object.FindObjectsByType<RadarController>(FindObjectsInactive.Include, FindObjectsSortMode.InstanceID);
            var radar = all.FirstOrDefault(found => found.isActiveAndEnabled);
            if (radar != null)
                return new Fix($"Take '{radar.name}'",
                    () => Fix.Change(_sweep, "Take a radar", it => it.Radar = radar));
            return all.Length > 0 ? RadarFixes.Enable(all[0])
                : new Fix("Make a radar",
                    () => SceneObjects.MakeRadar(_sweep.Target == null ? null : _sweep.Target.gameObject));
        }
    }
}
