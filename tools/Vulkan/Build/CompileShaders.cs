// An MSBuild task, compiled by MSBuild itself: see Shaders.targets.
using System;
using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using System.Text.RegularExpressions;
using Microsoft.Build.Framework;
using Microsoft.Build.Utilities;

/// <summary>
/// Compiles every kernel of the given .compute files to SPIR-V with glslangValidator. Each file gets a folder with its
/// own path below Output. It holds KERNEL.spv for each kernel, and sources.json with the SHA-256 of all source files
/// and the names of each kernel's byte address buffers, which SPIR-V does not tell from structured buffers of uint.
/// </summary>
public sealed class CompileShaders : Task
{
    const string Compiler = "glslangValidator";

    // "ERROR: Shaders/Trace.compute:12: 'x' : unknown variable"
    static readonly Regex ErrorLine = new Regex(@"^ERROR: (.+?):(\d+): (.*)$");
    static readonly Regex KernelLine = new Regex(@"^\s*#pragma\s+kernel\s+(\w+)((?:\s+\w+(?:=\S+)?)*)\s*(?://.*)?$");

    // "RWByteAddressBuffer Total, Words;" in preprocessed source; a parameter has no semicolon
    static readonly Regex ByteAddressLine = new Regex(@"\b(?:RW)?ByteAddressBuffer\s+([\w\s,]+);");

    [Required] public ITaskItem[] Sources { get; set; }

    /// <summary>Base folder of the paths in #include and in the output.</summary>
    [Required] public string Root { get; set; }

    [Required] public string Output { get; set; }

    public override bool Execute()
    {
        if (Directory.Exists(Output))
            Directory.Delete(Output, true); // removes kernels that no longer exist
        Directory.CreateDirectory(Output);
        for (int i = 0; i < Sources.Length && !Log.HasLoggedErrors; i++)
            Compile(Sources[i].GetMetadata("FullPath"));
        return !Log.HasLoggedErrors;
    }

    void Compile(string fullPath)
    {
        string path = Relative(fullPath);
        string folder = Path.Combine(Output, path);
        var read = new SortedSet<string>(StringComparer.Ordinal) { path };
        var kernels = new List<string>();
        var byteAddress = new List<string>();
        foreach (var match in File.ReadLines(fullPath).Select(line => KernelLine.Match(line))
            .Where(match => match.Success))
        {
            Directory.CreateDirectory(folder);
            string kernel = match.Groups[1].Value;
            var defines = match.Groups[2].Value.Split(new[] { ' ', '\t' }, StringSplitOptions.RemoveEmptyEntries);
            if (!CompileKernel(path, kernel, defines, Path.Combine(folder, kernel + ".spv"), read))
                return;
            kernels.Add(kernel);
            byteAddress.Add(ByteAddressBuffers(path, defines));
        }
        if (kernels.Count == 0)
            Log.LogError(null, null, null, fullPath, 0, 0, 0, 0, "no kernel; declare one as in: #pragma kernel Trace");
        else
            File.WriteAllText(Path.Combine(folder, "sources.json"), Json(kernels, byteAddress, read));
    }

    bool CompileKernel(string path, string kernel, string[] defines, string output, SortedSet<string> read)
    {
        string dependencies = output + ".d";
        var arguments = Arguments(defines, "-V", "-e", kernel, "--auto-map-bindings", "--hlsl-iomap",
            "--depfile", dependencies, "-o", output, path);

        string messages = Run(arguments, out int exitCode);
        if (messages == null)
            return false;
        if (exitCode != 0 || !File.Exists(output))
        {
            Report(path, kernel, messages);
            return false;
        }
        // "OUTPUT: FILE FILE ...", spaces within a name escaped
        string list = File.ReadAllText(dependencies).Trim().Substring(output.Replace(" ", "\\ ").Length + 1);
        foreach (Match file in Regex.Matches(list, @"(?:\\ |\S)+"))
            read.Add(Relative(Path.Combine(Root, file.Value.Replace("\\ ", " "))));
        File.Delete(dependencies);
        return true;
    }

    /// <summary>Names of the byte address buffers that a kernel's source declares, as JSON strings.</summary>
    string ByteAddressBuffers(string path, string[] defines) => string.Join(", ",
        ByteAddressLine.Matches(Run(Arguments(defines, "-E", path), out _)).Cast<Match>()
            .SelectMany(match => match.Groups[1].Value.Split(','))
            .Select(declared => '"' + Regex.Match(declared, @"\w+").Value + '"').Distinct());

    static List<string> Arguments(string[] defines, params string[] more)
    {
        var arguments = new List<string> { "-D", "-S", "comp", "-I.", "-DSHADER_API_VULKAN=1" };
        arguments.AddRange(defines.Select(define => "-D" + define));
        arguments.AddRange(more);
        return arguments;
    }

    string Run(List<string> arguments, out int exitCode)
    {
        exitCode = 0;
        var start = new ProcessStartInfo(Compiler, string.Join(" ", arguments.Select(argument => '"' + argument + '"')))
        {
            WorkingDirectory = Root, UseShellExecute = false,
            RedirectStandardOutput = true, RedirectStandardError = true,
        };
        try
        {
            using (var process = Process.Start(start))
            {
                var errors = process.StandardError.ReadToEndAsync();
                string messages = process.StandardOutput.ReadToEnd() + errors.Result;
                process.WaitForExit();
                exitCode = process.ExitCode;
                return messages;
            }
        }
        catch (Win32Exception)
        {
            Log.LogError(Compiler + " is not installed: apt-get install glslang-tools");
            return null;
        }
    }

    void Report(string path, string kernel, string messages)
    {
        bool found = false;
        foreach (var match in messages.Split('\n').Select(line => ErrorLine.Match(line.Trim()))
            .Where(match => match.Success))
        {
            string file = Path.GetFullPath(Path.Combine(Root, match.Groups[1].Value));
            Log.LogError(null, null, null, file, int.Parse(match.Groups[2].Value), 0, 0, 0,
                "kernel " + kernel + ": " + match.Groups[3].Value.Trim());
            found = true;
        }
        if (!found)
            Log.LogError(null, null, null, Path.Combine(Root, path), 0, 0, 0, 0, "kernel " + kernel + ": "
                + (messages.Contains("Entry point not found") ? "there is no function of that name" : messages.Trim()));
    }

    string Json(List<string> kernels, List<string> byteAddress, SortedSet<string> read)
    {
        var text = new StringBuilder("{\n  \"kernels\": [");
        text.Append(string.Join(", ", kernels.Select(kernel => '"' + kernel + '"')));
        text.Append("],\n  \"byteAddressBuffers\": {\n");
        text.Append(string.Join(",\n",
            kernels.Select((kernel, i) => "    \"" + kernel + "\": [" + byteAddress[i] + ']')));
        text.Append("\n  },\n  \"sources\": {\n");
        text.Append(
            string.Join(",\n", read.Select(path => "    \"" + path + "\": \"" + Hash(Path.Combine(Root, path)) + '"')));
        return text.Append("\n  }\n}\n").ToString();
    }

    static string Hash(string path)
    {
        using (var sha = SHA256.Create())
            return string.Concat(sha.ComputeHash(File.ReadAllBytes(path)).Select(value => value.ToString("x2")));
    }

    string Relative(string path)
    {
        string root = Path.GetFullPath(Root).TrimEnd('/') + "/";
        path = Path.GetFullPath(path);
        return path.StartsWith(root, StringComparison.Ordinal) ? path.Substring(root.Length) : path;
    }
}
