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
using System.Threading.Tasks;
using Microsoft.Build.Framework;
using Microsoft.Build.Utilities;

/// <summary>
/// Compiles every kernel of the given .compute files to SPIR-V with glslangValidator. Each file gets a folder with its
/// own path below Output. It holds KERNEL.spv for each kernel, and sources.json with the SHA-256 of all source files
/// and the names of each kernel's byte address buffers, which SPIR-V does not tell from structured buffers of uint.
/// </summary>
public sealed class CompileShaders : Microsoft.Build.Utilities.Task
{
    const string Compiler = "glslangValidator", IsMissing = Compiler + " is not installed: apt-get install glslang-tools";

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
        var files = Sources.Select(source => new ShaderFile(Relative(source.GetMetadata("FullPath")), Root)).ToArray();
        Parallel.ForEach(files.SelectMany(file => file.Kernels), Compile);
        foreach (var file in files.TakeWhile(_ => !Log.HasLoggedErrors))
            Finish(file);
        return !Log.HasLoggedErrors;
    }

    // A .compute file.
    sealed class ShaderFile
    {
        public readonly string Path;       // from the base folder
        public readonly Kernel[] Kernels;

        public ShaderFile(string path, string root)
        {
            Path = path;
            Kernels = File.ReadLines(System.IO.Path.Combine(root, path)).Select(line => KernelLine.Match(line))
                .Where(match => match.Success).Select(match => new Kernel(this, match)).ToArray();
        }
    }

    // A kernel of a file, and what its compiler has said.
    sealed class Kernel
    {
        public readonly ShaderFile File;
        public readonly string Name;
        public readonly string[] Defines;
        public string[] Read = { };        // source files
        public string ByteAddressBuffers;
        public string Problem;             // null: none

        public Kernel(ShaderFile file, Match declared)
        {
            File = file;
            Name = declared.Groups[1].Value;
            Defines = declared.Groups[2].Value.Split(new[] { ' ', '\t' }, StringSplitOptions.RemoveEmptyEntries);
        }
    }

    string FolderOf(ShaderFile file) => Path.Combine(Output, file.Path);

    void Compile(Kernel kernel)
    {
        string folder = FolderOf(kernel.File), output = Path.Combine(folder, kernel.Name + ".spv"), dependencies = output + ".d";
        Directory.CreateDirectory(folder);
        var arguments = Arguments(kernel.Defines, "-V", "-e", kernel.Name, "--auto-map-bindings", "--hlsl-iomap",
            "--depfile", dependencies, "-o", output, kernel.File.Path);
        string messages = Run(arguments, out int exitCode);
        if (exitCode != 0 || !File.Exists(output))
        {
            kernel.Problem = messages;
            return;
        }
        // "OUTPUT: FILE FILE ...", spaces within a name escaped
        string list = File.ReadAllText(dependencies).Trim().Substring(output.Replace(" ", "\\ ").Length + 1);
        kernel.Read = Regex.Matches(list, @"(?:\\ |\S)+").Cast<Match>()
            .Select(file => Relative(Path.Combine(Root, file.Value.Replace("\\ ", " ")))).ToArray();
        File.Delete(dependencies);
        kernel.ByteAddressBuffers = ByteAddressBuffers(kernel.File.Path, kernel.Defines);
    }

    // Reports the first problem of a file, or writes what its kernels were made of.
    void Finish(ShaderFile file)
    {
        var refused = file.Kernels.FirstOrDefault(kernel => kernel.Problem != null);
        if (refused != null)
            Report(refused);
        else if (file.Kernels.Length == 0)
            Log.LogError(null, null, null, Path.Combine(Root, file.Path), 0, 0, 0, 0,
                "no kernel; declare one as in: #pragma kernel Trace");
        else
            File.WriteAllText(Path.Combine(FolderOf(file), "sources.json"), Json(file));
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
            exitCode = 1;
            return IsMissing;
        }
    }

    void Report(Kernel kernel)
    {
        if (kernel.Problem == IsMissing)
        {
            Log.LogError(IsMissing);
            return;
        }
        bool found = false;
        foreach (var match in kernel.Problem.Split('\n').Select(line => ErrorLine.Match(line.Trim()))
            .Where(match => match.Success))
        {
            string file = Path.GetFullPath(Path.Combine(Root, match.Groups[1].Value));
            Log.LogError(null, null, null, file, int.Parse(match.Groups[2].Value), 0, 0, 0,
                "kernel " + kernel.Name + ": " + match.Groups[3].Value.Trim());
            found = true;
        }
        if (!found)
            Log.LogError(null, null, null, Path.Combine(Root, kernel.File.Path), 0, 0, 0, 0, "kernel " + kernel.Name + ": "
                + (kernel.Problem.Contains("Entry point not found") ? "there is no function of that name"
                    : kernel.Problem.Trim()));
    }

    string Json(ShaderFile file)
    {
        var read = new SortedSet<string>(file.Kernels.SelectMany(kernel => kernel.Read), StringComparer.Ordinal) { file.Path };
        var text = new StringBuilder("{\n  \"kernels\": [");
        text.Append(string.Join(", ", file.Kernels.Select(kernel => '"' + kernel.Name + '"')));
        text.Append("],\n  \"byteAddressBuffers\": {\n");
        text.Append(string.Join(",\n",
            file.Kernels.Select(kernel => "    \"" + kernel.Name + "\": [" + kernel.ByteAddressBuffers + ']')));
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
