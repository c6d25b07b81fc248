using UnityEngine;

namespace Glint.Host.Tests;

[RequireComponent(typeof(Camera))]
public sealed class Scope : MonoBehaviour
{
}
