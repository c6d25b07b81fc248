using Glint.Host;

namespace UnityEngine;

/// <summary>Times in seconds. Within FixedUpdate, time and deltaTime are those of the fixed step.</summary>
public class Time
{
    public static float time => (float)timeAsDouble;

    public static double timeAsDouble => Clock.InFixedStep ? Clock.FixedTime : Clock.Time;

    public static float timeSinceLevelLoad => (float)Clock.SinceLevelLoad;

    public static double timeSinceLevelLoadAsDouble => Clock.SinceLevelLoad;

    public static float deltaTime => (float)(Clock.InFixedStep ? Clock.FixedDelta : Clock.Delta);

    public static float unscaledTime => (float)Clock.UnscaledTime;

    public static double unscaledTimeAsDouble => Clock.UnscaledTime;

    public static float unscaledDeltaTime => (float)Clock.UnscaledDelta;

    public static float fixedTime => (float)Clock.FixedTime;

    public static double fixedTimeAsDouble => Clock.FixedTime;

    public static float fixedDeltaTime
    {
        get => (float)Clock.FixedDelta;
        set => Clock.FixedDelta = Mathf.Clamp(value, 0.0001f, 10f);
    }

    public static float maximumDeltaTime
    {
        get => (float)Clock.MaximumDelta;
        set => Clock.MaximumDelta = Mathf.Max(value, (float)Clock.FixedDelta);
    }

    public static float timeScale
    {
        get => (float)Clock.Scale;
        set
        {
            if (value is >= 0f and <= 100f)
                Clock.Scale = value;
            else
                Debug.LogError($"Time.timeScale cannot be {value}: it is between 0 and 100.");
        }
    }

    public static float captureDeltaTime
    {
        get => (float)Clock.CaptureDelta;
        set => Clock.CaptureDelta = value;
    }

    public static int frameCount => Clock.Frame;

    public static float realtimeSinceStartup => (float)Clock.SinceStartup;

    public static double realtimeSinceStartupAsDouble => Clock.SinceStartup;

    public static bool inFixedTimeStep => Clock.InFixedStep;
}
