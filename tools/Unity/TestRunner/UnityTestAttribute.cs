using System;
using System.Collections;
using Glint.Host;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Builders;
using NUnit.Framework.Internal.Commands;

namespace UnityEngine.TestTools;

[AttributeUsage(AttributeTargets.Method)]
public class UnityTestAttribute : CombiningStrategyAttribute, ISimpleTestBuilder, IImplyFixture,
    IApplyToTest, IWrapTestMethod
{
    readonly NUnitTestCaseBuilder _builder = new();

    public UnityTestAttribute() : base(new RoutineCases(), new ParameterDataSourceProvider())
    {
    }

    TestMethod ISimpleTestBuilder.BuildFrom(IMethodInfo method, Test suite)
        => _builder.BuildTestMethod(method, suite,
            RoutineCases.Expecting(new TestCaseParameters { TestName = method.Name }));

    public new void ApplyToTest(Test test)
    {
        if (test.Method.ReturnType.Type != typeof(IEnumerator))
            test.MakeInvalid("a method with [UnityTest] must return IEnumerator");
    }

    // Called before a test runs; its method, once called, is then stepped to its end.
    TestCommand ICommandWrapper.Wrap(TestCommand command)
    {
        var test = command.Test;
        test.Method = new RoutineMethod(test.Method, TimeLimit.TakeFrom(test));
        return command;
    }
}
