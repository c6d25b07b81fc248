using System;
using System.Linq;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace UnityEngine.TestTools;

[AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class | AttributeTargets.Method, AllowMultiple = true)]
public class UnityPlatformAttribute : NUnitAttribute, IApplyToTest
{
    public UnityPlatformAttribute()
    {
    }

    public UnityPlatformAttribute(params RuntimePlatform[] include) => this.include = include;

    public RuntimePlatform[] include { get; set; } = { };

    public RuntimePlatform[] exclude { get; set; } = { };

    public void ApplyToTest(Test test)
    {
        var platform = Application.platform;
        if (test.RunState != RunState.Runnable
            || (include.Length == 0 || include.Contains(platform)) && !exclude.Contains(platform))
            return;
        test.RunState = RunState.Skipped;
        test.Properties.Set(PropertyNames.SkipReason, $"not for {platform}");
    }
}
