using System.Collections;
using System.Collections.Generic;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Builders;

namespace Glint.Host;

/// <summary>
/// Every combination of the arguments of [Values], [ValueSource] and similar, for methods that return a routine.
/// </summary>
internal sealed class RoutineCases : ICombiningStrategy
{
    readonly CombinatorialStrategy _combinations = new();

    public IEnumerable<ITestCaseData> GetTestCases(IEnumerable[] sources)
    {
        foreach (var parameters in _combinations.GetTestCases(sources))
            yield return Expecting((TestCaseParameters)parameters);
    }

    // NUnit accepts a method that returns a value only with an expected result; a completed routine returns null.
    internal static TestCaseParameters Expecting(TestCaseParameters parameters)
    {
        parameters.ExpectedResult = null;
        return parameters;
    }
}
