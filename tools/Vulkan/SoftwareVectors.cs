using System;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Glint.Vulkan;

/// <summary>
/// The width of the vectors in which Mesa's software device computes: a lane is a thread of a kernel. The driver takes 256
/// bits on every processor with AVX, unless an environment variable says otherwise when it is loaded. Where vectors of 512
/// bits are as fast, the kernels of the bench take 0.88 times as long with them. Kernels that the driver's own cache has keep
/// their width.
/// </summary>
static partial class SoftwareVectors
{
    internal const string Variable = "LP_NATIVE_VECTOR_WIDTH";
    const string WidestBits = "512";

    /// <summary>Sets the variable, which the driver reads, if the user has not and the processor gains.</summary>
    internal static void Widen()
    {
        // .NET sets variables for itself and its child processes only.
        if (OperatingSystem.IsLinux() && IsGain(Environment.GetEnvironmentVariable(Variable), Vector512.IsHardwareAccelerated))
            _ = SetVariable(Variable, WidestBits, 1);
    }

    /// <param name="set">Value of the variable; null or empty: none.</param>
    /// <param name="isFast">Whether vectors of 512 bits run at full speed.</param>
    internal static bool IsGain(string set, bool isFast) => isFast && string.IsNullOrEmpty(set);

    [LibraryImport("libc", EntryPoint = "setenv", StringMarshalling = StringMarshalling.Utf8)]
    private static partial int SetVariable(string name, string value, int overwrite);
}
