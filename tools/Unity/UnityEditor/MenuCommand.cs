using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>What a menu was opened on.</summary>
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
