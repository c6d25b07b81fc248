namespace Glint.Host;

/// <summary>Where in the frame a waiting coroutine goes on.</summary>
internal enum ResumePoint
{
    FixedUpdate,
    Update,
    EndOfFrame,
}
