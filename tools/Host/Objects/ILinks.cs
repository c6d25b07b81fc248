using System;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>Turns references of a file into objects.</summary>
internal interface ILinks
{
    /// <summary>The object, if it has that type; else null, with a warning if it is missing.</summary>
    /// <param name="holder">The object with the reference.</param>
    /// <param name="path">Property path of the reference in the holder.</param>
    Object Resolve(ObjectReference reference, Type type, ObjectRecord holder, string path);
}
