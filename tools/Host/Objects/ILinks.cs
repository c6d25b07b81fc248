using System;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>Turns references of a file into objects.</summary>
internal interface ILinks
{
    /// <summary>The object, if it is of that type; else null, with a warning when it should have been there.</summary>
    /// <param name="holder">The object with the reference.</param>
    /// <param name="path">Where in the holder the reference stands.</param>
    Object Resolve(ObjectReference reference, Type type, ObjectRecord holder, string path);
}
