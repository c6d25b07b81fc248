namespace UnityEngine;

public enum RuntimePlatform
{
    OSXEditor = 0,
    OSXPlayer = 1,
    WindowsPlayer = 2,
    WindowsEditor = 7,
    LinuxPlayer = 13,
    LinuxEditor = 16,
    LinuxServer = 43,
    WindowsServer = 44,
    OSXServer = 45,
}
