using System;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>Writes every message into the diary.</summary>
internal class Talker : MonoBehaviour
{
    void Awake() => Diary.Write(this, "Awake");
    void OnEnable() => Diary.Write(this, "OnEnable");
    void Start() => Diary.Write(this, "Start");
    void Update() => Diary.Write(this, "Update");
    void LateUpdate() => Diary.Write(this, "LateUpdate");
    void OnDisable() => Diary.Write(this, "OnDisable");
    void OnDestroy() => Diary.Write(this, "OnDestroy");
    void OnApplicationQuit() => Diary.Write(this, "OnApplicationQuit");
    void OnValidate() => Diary.Write(this, "OnValidate");
    void Reset() => Diary.Write(this, "Reset");
}

/// <summary>Inherits private messages from its base class, which must still be called.</summary>
internal sealed class QuietHeir : Talker
{
}

[ExecuteAlways]
internal sealed class EditTalker : MonoBehaviour
{
    void Awake() => Diary.Write(this, "Awake");
    void OnEnable() => Diary.Write(this, "OnEnable");
    void OnDisable() => Diary.Write(this, "OnDisable");
    void OnDestroy() => Diary.Write(this, "OnDestroy");
}

/// <summary>Runs the test's delegate.</summary>
internal sealed class Actor : MonoBehaviour
{
    internal Action<Actor> OnAwake, OnUpdate, OnLateUpdate, OnFixedUpdate;

    void Awake() => OnAwake?.Invoke(this);
    void FixedUpdate() => OnFixedUpdate?.Invoke(this);
    void Update() => OnUpdate?.Invoke(this);
    void LateUpdate() => OnLateUpdate?.Invoke(this);
}

internal sealed class OnlyStart : MonoBehaviour
{
    internal Action Started;

    void Start() => Started();
}

internal sealed class Mover : MonoBehaviour
{
    internal Action Disabled;

    void OnDisable() => Disabled?.Invoke();
}

[DefaultExecutionOrder(-10)]
internal sealed class EarlyBird : MonoBehaviour
{
    void Awake() => Diary.Write(this, "Awake");
    void OnEnable() => Diary.Write(this, "OnEnable");
    void Start() => Diary.Write(this, "Start");
    void Update() => Diary.Write(this, "Update");
}

[DefaultExecutionOrder(10)]
internal sealed class Latecomer : MonoBehaviour
{
    void Awake() => Diary.Write(this, "Awake");
    void OnEnable() => Diary.Write(this, "OnEnable");
    void Start() => Diary.Write(this, "Start");
    void Update() => Diary.Write(this, "Update");
}

[RequireComponent(typeof(MeshFilter), typeof(Actor))]
[DisallowMultipleComponent]
internal sealed class Demanding : MonoBehaviour
{
}
