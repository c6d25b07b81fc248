namespace Unity.Collections;

public enum NativeArrayOptions
{
    UninitializedMemory = 0,
    ClearMemory = 1,
}
