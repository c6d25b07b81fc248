using System.Text.RegularExpressions;
using Glint.Host;

namespace UnityEngine.TestTools;

public static class LogAssert
{
    public static bool ignoreFailingMessages
    {
        get => LogScope.Current.IgnoresFailing;
        set => LogScope.Current.IgnoresFailing = value;
    }

    public static void Expect(LogType type, string message) => LogScope.Current.Expect(new ExpectedLog(type, message));

    public static void Expect(LogType type, Regex message) => LogScope.Current.Expect(new ExpectedLog(type, message));

    public static void Expect(string message) => LogScope.Current.Expect(new ExpectedLog(null, message));

    public static void Expect(Regex message) => LogScope.Current.Expect(new ExpectedLog(null, message));

    public static void NoUnexpectedReceived() => LogScope.Current.RequireAllExpected();
}
