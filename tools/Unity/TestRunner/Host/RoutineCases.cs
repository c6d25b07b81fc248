using System.Collections;
using System.Collections.Generic;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Builders;

namespace Glint.Host;

/// <summary>
/// Every combination of the arguments given by [Values], [ValueSource] and the like, for methods that return a routine.
/// </summary>
internal sealed class RoutineCases : ICombiningStrategy
{
    readonly CombinatorialStrategy _combinations = new();

    public IEnumerable<ITestCaseData> GetTestCases(IEnumerable[] sources)
    {
        foreach (var parameters in _combinations.GetTestCases(sources))
            yield return Expecting((TestCaseParameters)parameters);
    }

    // NUnit takes a method that returns a value only where a result is expected;
    // a routine that ran to its end leaves null.
    internal static TestCaseParameters Expecting(TestCaseParameters parameters)
    {
        parameters.ExpectedResult = null;
        return parameters;
    }
}
