namespace UnityEngine.UIElements;

public delegate void EventCallback<in TEventType>(TEventType evt);

public enum TrickleDown
{
    NoTrickleDown,
    TrickleDown,
}

/// <summary>Only tests raise events: there is no pointer and no panel.</summary>
public abstract class EventBase
{
}

public abstract class EventBase<T> : EventBase
    where T : EventBase<T>, new()
{
}

public class ChangeEvent<T> : EventBase<ChangeEvent<T>>
{
    public T previousValue { get; protected internal set; }

    public T newValue { get; protected internal set; }
}

public abstract class PointerEventBase<T> : EventBase<T>
    where T : PointerEventBase<T>, new()
{
    public Vector3 localPosition { get; protected internal set; }
}

public sealed class PointerMoveEvent : PointerEventBase<PointerMoveEvent>
{
}

public sealed class PointerLeaveEvent : PointerEventBase<PointerLeaveEvent>
{
}

public sealed class ClickEvent : PointerEventBase<ClickEvent>
{
}

public abstract class PanelChangedEventBase<T> : EventBase<T>
    where T : PanelChangedEventBase<T>, new()
{
}

public class AttachToPanelEvent : PanelChangedEventBase<AttachToPanelEvent>
{
}

public class DetachFromPanelEvent : PanelChangedEventBase<DetachFromPanelEvent>
{
}

public class GeometryChangedEvent : EventBase<GeometryChangedEvent>
{
}
