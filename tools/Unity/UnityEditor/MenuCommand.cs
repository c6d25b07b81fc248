using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>The object of a context menu.</summary>
public sealed class MenuCommand
{
    public Object context;
    public int userData;

    public MenuCommand(Object inContext, int inUserData)
    {
        context = inContext;
        userData = inUserData;
    }

    public MenuCommand(Object inContext)
        : this(inContext, 0)
    {
    }
}
