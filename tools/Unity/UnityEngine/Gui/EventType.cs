namespace UnityEngine;

public enum EventType
{
    MouseDown = 0,
    Repaint = 7,
    Layout = 8,
}
