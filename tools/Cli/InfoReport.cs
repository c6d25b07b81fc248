using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Runtime.InteropServices;
using Glint.Core;
using Glint.Editor;
using Glint.Vulkan;

namespace Glint.Cli;

/// <summary>Writes versions, devices, and the limits of the device in use.</summary>
sealed class InfoReport(Terminal terminal)
{
    public int Write(CommandLine line)
    {
        // The device is opened before any output, since it may be missing.
        using var used = VulkanDevice.Open(line.Get(Options.Device));
        Columns("", [
            ("Glint", GlintVersion.Text),
            ("Unity", UnityEngine.Application.unityVersion + " (headless stand-in)"),
            (".NET", $"{Environment.Version} on {RuntimeInformation.OSDescription} "
                + $"({RuntimeInformation.ProcessArchitecture}), {Environment.ProcessorCount} processors"),
            ("Project", ProjectFolder.Current ?? "none here")
        ]);

        terminal.Out.WriteLine();
        terminal.Out.WriteLine("Devices (* in use):");
        Columns("  ", VulkanDevice.List().Select(device => (
            $"{(device.Index == used.Info.Index ? '*' : ' ')} {device.Index}  {device.Name}",
            $"{device.Type}, Vulkan {device.ApiVersion}, driver {device.Driver}")));

        var limits = used.Limits;
        terminal.Out.WriteLine();
        terminal.Out.WriteLine($"Limits of {used.Info.Name}:");
        Columns("  ", [
            ("memory", Bytes(limits.MemoryBytes)),
            ("largest storage buffer", Bytes(limits.MaxStorageBufferRange)),
            ("largest uniform buffer", Bytes(limits.MaxUniformBufferRange)),
            ("storage buffers of a kernel", limits.MaxStorageBuffersPerStage.ToString(CultureInfo.InvariantCulture)),
            ("groups of a dispatch", $"{limits.MaxGroupsX} x {limits.MaxGroupsY} x {limits.MaxGroupsZ}"),
            ("threads of a group", $"{limits.MaxGroupInvocations}, "
                + $"at most {limits.MaxGroupSizeX} x {limits.MaxGroupSizeY} x {limits.MaxGroupSizeZ}")
        ]);
        return 0;
    }

    void Columns(string margin, IEnumerable<(string name, string value)> rows)
    {
        var all = rows.ToArray();
        int width = all.Max(row => row.name.Length) + 3;
        foreach (var row in all)
            terminal.Out.WriteLine(margin + row.name.PadRight(width) + row.value);
    }

    static string Bytes(long bytes)
    {
        string[] units = ["bytes", "KiB", "MiB", "GiB", "TiB"];
        double value = bytes;
        int unit = 0;
        for (; value >= 1024 && unit < units.Length - 1; unit++)
            value /= 1024;
        return value.ToString("0.#", CultureInfo.InvariantCulture) + " " + units[unit];
    }
}
