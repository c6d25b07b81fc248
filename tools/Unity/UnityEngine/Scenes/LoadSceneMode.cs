using System;

namespace UnityEngine.SceneManagement;

public enum LoadSceneMode
{
    Single,
    Additive,
}

[Flags]
public enum LocalPhysicsMode
{
    None = 0,
    Physics2D = 1,
    Physics3D = 2,
}

[Flags]
public enum UnloadSceneOptions
{
    None = 0,
    UnloadAllEmbeddedSceneObjects = 1,
}

public struct LoadSceneParameters
{
    public LoadSceneParameters(LoadSceneMode mode)
        : this(mode, LocalPhysicsMode.None)
    {
    }

    public LoadSceneParameters(LoadSceneMode mode, LocalPhysicsMode physicsMode)
    {
        loadSceneMode = mode;
        localPhysicsMode = physicsMode;
    }

    public LoadSceneMode loadSceneMode { get; set; }
    public LocalPhysicsMode localPhysicsMode { get; set; }
}

public struct CreateSceneParameters
{
    public CreateSceneParameters(LocalPhysicsMode physicsMode) => localPhysicsMode = physicsMode;

    public LocalPhysicsMode localPhysicsMode { get; set; }
}
