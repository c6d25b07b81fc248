using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using UnityEngine.TestTools;

namespace Glint.Host;

/// <summary>
/// Attribute of a test assembly or a fixture. For every [Test] and [UnityTest] it runs [UnitySetUp] before [SetUp]
/// (base class first) and [UnityTearDown] after [TearDown] (base class last), and checks the log against LogAssert.
/// </summary>
[AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class)]
public sealed class UnityTestActionAttribute : Attribute, ITestAction
{
    const BindingFlags AnyMethod = BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public
        | BindingFlags.NonPublic | BindingFlags.FlattenHierarchy;

    public ActionTargets Targets => ActionTargets.Test;

    public void BeforeTest(ITest test)
    {
        LogScope.Open();
        foreach (var method in MethodsWith<UnitySetUpAttribute>(test))
            Run(method);
    }

    public void AfterTest(ITest test)
    {
        var result = TestExecutionContext.CurrentContext.CurrentResult;
        using var logs = LogScope.Current;
        foreach (var method in MethodsWith<UnityTearDownAttribute>(test).Reverse())
        {
            try
            {
                Run(method);
            }
            catch (Exception exception)
            {
                result.RecordTearDownException(exception);
            }
        }
        // A failed test has already reported its reason; missing messages and the final error add nothing.
        var complaint = logs.UnexpectedErrors();
        if (result.ResultState.Status != TestStatus.Failed)
            complaint ??= logs.MissingLogs();
        if (complaint != null && result.Message?.Contains(complaint) != true)
            result.SetResult(ResultState.Failure,
                string.IsNullOrEmpty(result.Message) ? complaint : result.Message + Environment.NewLine + complaint,
                result.StackTrace);
    }

    static void Run(MethodInfo method)
    {
        if (method.ReturnType != typeof(IEnumerator))
            throw new InvalidOperationException($"{method.DeclaringType.FullName}.{method.Name} "
                + "must return IEnumerator");
        var routine = (IEnumerator)Reflect.InvokeMethod(method, TestExecutionContext.CurrentContext.TestObject);
        RoutineRun.ToEnd(routine, TimeLimit.Default);
    }

    static IEnumerable<MethodInfo> MethodsWith<T>(ITest test) where T : Attribute
        => test.TypeInfo.Type.GetMethods(AnyMethod).Where(method => method.IsDefined(typeof(T), true))
            .OrderBy(method => Depth(method.DeclaringType));

    static int Depth(Type type) => type == null ? 0 : 1 + Depth(type.BaseType);
}
