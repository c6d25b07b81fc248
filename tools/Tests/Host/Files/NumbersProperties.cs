using System.Globalization;
using FsCheck;
using FsCheck.Fluent;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Host.Tests;

public sealed class NumbersProperties
{
    [Test]
    public void Format_AnyDouble_ReadsBackAndIsNotLongerThanTheRuntimes() => Prop.ForAll<double>(value =>
    {
        if (!double.IsFinite(value))
            return true;
        string text = Numbers.Format(value), shortest = value.ToString("R", CultureInfo.InvariantCulture);
        return double.Parse(text, CultureInfo.InvariantCulture) == value && text.Length <= shortest.Length;
    }).Check(Config.QuickThrowOnFailure.WithMaxTest(5000));
}
