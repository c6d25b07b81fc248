using System;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;

namespace Glint.Host;

/// <summary>Properties of the machine for SystemInfo, except the graphics device.</summary>
internal static class Machine
{
    const string ProcessorFile = "/proc/cpuinfo";

    /// <summary>Kernel, distribution and word size, as in "Linux 6.1.0 Debian GNU/Linux 12 (bookworm) 64bit".</summary>
    internal static string OperatingSystem { get; } =
        $"{(System.OperatingSystem.IsLinux() ? "Linux " : "")}{Environment.OSVersion.Version.ToString(3)} "
        + $"{RuntimeInformation.OSDescription} {IntPtr.Size * 8}bit";

    /// <summary>The processor's model as Linux names it, elsewhere its architecture.</summary>
    internal static string Processor { get; } = ReadProcessor() ?? RuntimeInformation.ProcessArchitecture.ToString();

    internal static string Vendor(uint id) => id switch
    {
        0x1002 => "AMD",
        0x106b => "Apple",
        0x10de => "NVIDIA",
        0x13b5 => "ARM",
        0x5143 => "Qualcomm",
        0x8086 => "Intel",
        0x10005 => "Mesa",
        _ => $"0x{id:x4}",
    };

    static string ReadProcessor() => !File.Exists(ProcessorFile) ? null : File.ReadLines(ProcessorFile)
        .Where(line => line.StartsWith("model name", StringComparison.Ordinal))
        .Select(line => line[(line.IndexOf(':') + 1)..].Trim())
        .FirstOrDefault();
}
