namespace Glint.Host;

/// <summary>The point of the frame at which a suspended coroutine resumes.</summary>
internal enum ResumePoint
{
    FixedUpdate,
    Update,
    EndOfFrame,
}
