using Glint;
using UnityEngine;

/// <summary>
/// How to use the radar from code: put this on any object of a scene with a radar, which its field Radar then names, and
/// press play.
/// </summary>
public sealed class LogRadar : MonoBehaviour
{
    [SerializeField]
    RadarController _radar;

    // In the editor, when the component is added.
    void Reset() => _radar = FindFirstObjectByType<RadarController>();

    void Start()
    {
        var result = _radar.Trace();
        Debug.Log($"{result.RaysReceived} of {result.RaysEmitted} rays came back: "
            + $"amplitude {result.Amplitude:0.00} ({result.AmplitudeDb:0.00} dB)");
        foreach (var ray in result.Rays)
            Debug.DrawLine(_radar.transform.position, ray.LastHit, Color.green, 10);
    }
}
