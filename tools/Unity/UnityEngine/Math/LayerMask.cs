using System;
using Glint.Host;

namespace UnityEngine;

[Serializable]
public struct LayerMask
{
    int m_Mask;

    public int value { get => m_Mask; set => m_Mask = value; }

    public static implicit operator int(LayerMask mask) => mask.m_Mask;
    public static implicit operator LayerMask(int intVal) => new() { m_Mask = intVal };

    public static string LayerToName(int layer) => TagManager.LayerToName(layer);

    /// <summary>-1 for an unknown name.</summary>
    public static int NameToLayer(string layerName) => TagManager.NameToLayer(layerName);

    public static int GetMask(params string[] layerNames)
    {
        if (layerNames == null)
            throw new ArgumentNullException(nameof(layerNames));
        int mask = 0;
        foreach (string name in layerNames)
        {
            int layer = NameToLayer(name);
            if (layer >= 0)
                mask |= 1 << layer;
        }
        return mask;
    }
}
