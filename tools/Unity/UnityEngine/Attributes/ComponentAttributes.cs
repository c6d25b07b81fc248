using System;

namespace UnityEngine;

[AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
public sealed class RequireComponent : Attribute
{
    public Type m_Type0;
    public Type m_Type1;
    public Type m_Type2;

    public RequireComponent(Type requiredComponent) => m_Type0 = requiredComponent;

    public RequireComponent(Type requiredComponent, Type requiredComponent2)
        : this(requiredComponent) => m_Type1 = requiredComponent2;

    public RequireComponent(Type requiredComponent, Type requiredComponent2, Type requiredComponent3)
        : this(requiredComponent, requiredComponent2) => m_Type2 = requiredComponent3;
}

[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public sealed class DisallowMultipleComponent : Attribute;

public sealed class AddComponentMenu : Attribute
{
    public AddComponentMenu(string menuName) => componentMenu = menuName;

    public AddComponentMenu(string menuName, int order)
        : this(menuName) => componentOrder = order;

    public string componentMenu { get; }
    public int componentOrder { get; }
}

public sealed class ExecuteAlways : Attribute;

public sealed class ExecuteInEditMode : Attribute;

[AttributeUsage(AttributeTargets.Class)]
public class DefaultExecutionOrder : Attribute
{
    public DefaultExecutionOrder(int order) => this.order = order;

    public int order { get; }
}

[AttributeUsage(AttributeTargets.Class, AllowMultiple = false, Inherited = false)]
public sealed class CreateAssetMenuAttribute : Attribute
{
    public string menuName { get; set; }
    public string fileName { get; set; }
    public int order { get; set; }
}

[AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
public sealed class ContextMenu : Attribute
{
    public readonly string menuItem;
    public readonly bool validate;
    public readonly int priority;

    public ContextMenu(string itemName)
        : this(itemName, false)
    {
    }

    public ContextMenu(string itemName, bool isValidateFunction)
        : this(itemName, isValidateFunction, 1000000)
    {
    }

    public ContextMenu(string itemName, bool isValidateFunction, int priority)
    {
        menuItem = itemName;
        validate = isValidateFunction;
        this.priority = priority;
    }
}

public enum RuntimeInitializeLoadType
{
    AfterSceneLoad,
    BeforeSceneLoad,
    AfterAssembliesLoaded,
    BeforeSplashScreen,
    SubsystemRegistration,
}

[AttributeUsage(AttributeTargets.Method, AllowMultiple = false)]
public class RuntimeInitializeOnLoadMethodAttribute : Scripting.PreserveAttribute
{
    public RuntimeInitializeOnLoadMethodAttribute()
        : this(RuntimeInitializeLoadType.AfterSceneLoad)
    {
    }

    public RuntimeInitializeOnLoadMethodAttribute(RuntimeInitializeLoadType loadType) => this.loadType = loadType;

    public RuntimeInitializeLoadType loadType { get; }
}
