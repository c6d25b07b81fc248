namespace UnityEditor;

public struct ObjectChangeEventStream
{
}

/// <summary>Changes are not tracked; a test raises the event.</summary>
public static class ObjectChangeEvents
{
    public delegate void ObjectChangeEventsHandler(ref ObjectChangeEventStream stream);

    public static event ObjectChangeEventsHandler changesPublished;

    internal static void Raise()
    {
        var changes = new ObjectChangeEventStream();
        changesPublished?.Invoke(ref changes);
    }
}
