using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit;
using NUnit.Framework.Api;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Builders;

namespace Glint.Host.Tests.TestRunner;

/// <summary>Runs one fixture with NUnit's runner within a running test, and returns its results.</summary>
internal sealed class FixtureRun : ITestAssemblyBuilder, IPreFilter
{
    readonly Type _fixture;

    FixtureRun(Type fixture) => _fixture = fixture;

    /// <summary>Results of its tests in the order of their names.</summary>
    internal static IReadOnlyList<ITestResult> Of(Type fixture)
    {
        var outer = TestExecutionContext.CurrentContext;
        try
        {
            var runner = new NUnitTestAssemblyRunner(new FixtureRun(fixture));
            var settings = new Dictionary<string, object>
            {
                [FrameworkPackageSettings.RunOnMainThread] = true,
                [FrameworkPackageSettings.SynchronousEvents] = true,
            };
            runner.Load(fixture.Assembly, settings);
            var results = Leaves(runner.Run(TestListener.NULL, TestFilter.Empty))
                .OrderBy(result => result.Name, StringComparer.Ordinal).ToList();
            return results.Count > 0 ? results : throw new InvalidOperationException($"no test in {fixture.Name}");
        }
        finally
        {
            outer.EstablishExecutionEnvironment();
        }
    }

    internal static ITestResult OfOne(Type fixture) => Of(fixture).Single();

    public ITest Build(Assembly assembly, IDictionary<string, object> options)
    {
        var suite = new TestAssembly(assembly, assembly.GetName().Name);
        suite.Add(new NUnitTestFixtureBuilder().BuildFrom(new TypeWrapper(_fixture), this));
        return suite;
    }

    public ITest Build(string assemblyName, IDictionary<string, object> options) =>
        Build(Assembly.Load(assemblyName), options);

    public bool IsMatch(Type type) => true;

    public bool IsMatch(Type type, MethodInfo method) => true;

    static IEnumerable<ITestResult> Leaves(ITestResult result) =>
        result.HasChildren ? result.Children.SelectMany(Leaves) : result.Test.IsSuite ? [] : [result];
}
