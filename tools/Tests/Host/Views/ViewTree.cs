using System;
using System.Linq;
using UnityEngine.UIElements;

namespace Glint.Host.Tests;

internal static class ViewTree
{
    /// <summary>The only matching element below an element, or the element itself.</summary>
    internal static T Find<T>(this VisualElement root, Func<T, bool> isIt)
        where T : VisualElement => root.Tree().OfType<T>().Single(isIt);
}
