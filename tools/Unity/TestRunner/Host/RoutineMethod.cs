using System;
using System.Collections;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace Glint.Host;

/// <summary>A test method whose call lasts until its routine has ended, one frame for each step.</summary>
internal sealed class RoutineMethod : MethodWrapper, IMethodInfo
{
    readonly IMethodInfo _method;
    readonly TimeSpan _limit;

    internal RoutineMethod(IMethodInfo method, TimeSpan limit) : base(method.TypeInfo.Type, method.MethodInfo)
    {
        _method = method;
        _limit = limit;
    }

    object IMethodInfo.Invoke(object fixture, params object[] args)
    {
        if (_method.Invoke(fixture, args) is IEnumerator routine)
            RoutineRun.ToEnd(routine, _limit);
        return null;
    }
}
