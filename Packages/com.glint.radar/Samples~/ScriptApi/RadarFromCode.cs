using System.IO;
using Glint.Core;
using UnityEngine;

namespace Glint.Samples
{
    /// <summary>
    /// A radar without a scene of its own: makes a plate and a radar that looks at it,
    /// traces it, reads the rays, and sweeps.
    /// </summary>
    public sealed class RadarFromCode : MonoBehaviour
    {
        [SerializeField, Tooltip("Packages/com.glint.radar/Shaders/Trace.compute")]
        ComputeShader _kernel;

        /// <summary>The kernel; in the editor it fills in by itself.</summary>
        public ComputeShader Kernel { get => _kernel; set => _kernel = value; }

        void Start()
        {
            var plate = MakePlate(1, 10);
            var radar = MakeRadar();
            var result = radar.Trace();
            Debug.Log($"{result.RaysReceived} of {result.RaysHit} rays that hit came back: "
                + $"amplitude {result.Amplitude:0.0}, {result.AmplitudeDb:0.0} dB");
            DrawRays(radar, result);
            Sweep(radar, plate,
                Path.Combine(Path.GetDirectoryName(Application.dataPath), "Results", nameof(RadarFromCode)));
        }

        /// <summary>A square plate across the radar's axis.</summary>
        /// <param name="side">Metres.</param>
        /// <param name="range">From the radar, metres.</param>
        public Transform MakePlate(float side, float range)
        {
            var plate = GameObject.CreatePrimitive(PrimitiveType.Quad).transform;
            plate.name = "Plate";
            plate.localScale = new Vector3(side, side, 1);
            plate.position = transform.position + range * Vector3.forward;
            return plate;
        }

        /// <summary>A radar at this object's place that looks along +Z, its receiver 0.2 m behind it.</summary>
        public RadarController MakeRadar()
        {
            var camera = new GameObject("Radar").AddComponent<Camera>();
            camera.transform.position = transform.position;
            camera.fieldOfView = 10;
            var receiver = new GameObject("Receiver").transform;
            receiver.SetParent(camera.transform, false);
            receiver.localPosition = new Vector3(0, 0, -0.2f);

            var radar = camera.gameObject.AddComponent<RadarController>();
            radar.enabled = false; // it would trace once more by itself on play
            radar.Kernel = _kernel;
            radar.Receiver = receiver;
            radar.ReceiverSize = new Vector2(3, 3);
            var settings = RadarSettings.Default;
            settings.FrequencyHz = 10e9;
            settings.RaysAcross = 320;
            settings.RaysDown = 180;
            radar.Settings = settings;
            return radar;
        }

        // Each received ray: where it was reflected last, how long its way was, and with which phase it came.
        static void DrawRays(RadarController radar, RadarResult result)
        {
            foreach (var ray in result.Rays)
                Debug.DrawLine(radar.transform.position, ray.LastHit, Color.green, 10);
            if (result.Rays.Length > 0)
                Debug.Log($"the first: {result.Rays[0].RefinedPathLength:0.000} m, {result.Rays[0].Bounces} bounces, "
                    + $"phase {result.Rays[0].Phase:0.00} rad");
        }

        /// <summary>Turns the target from -2 to 2 degrees and writes the same files as glint sweep.</summary>
        /// <param name="radar">Traces.</param>
        /// <param name="target">What is turned; it is put back afterwards.</param>
        /// <param name="folder">For results.csv and results.json.</param>
        /// <exception cref="GlintException">The files cannot be written, or the scene cannot be traced.</exception>
        public static void Sweep(RadarController radar, Transform target, string folder)
        {
            var setup = new SweepSetup(radar,
                new SweepPlan(SweepAxis.Angle.Parse("-2:2:0.5")))
            { Target = target, Scene = target.gameObject.scene.path };
            using (var results = ResultsFolder.Open(folder))
            using (var run = new SweepRun(setup, results))
                while (!run.IsComplete)
                {
                    var row = run.Step();
                    Debug.Log($"{row.Pose}: amplitude {row.Result.Amplitude:0.0}");
                }
        }
    }
}
