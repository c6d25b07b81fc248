using System;
using System.Buffers.Binary;
using System.IO;
using System.Security.Cryptography;
using System.Text;

namespace Glint.Vulkan;

/// <summary>
/// A file with what the driver compiled for one kernel: VkPipelineCache data after their checksum. Its name has device,
/// driver and kernel. It is written whole or not at all; a damaged or foreign one counts as missing.
/// </summary>
sealed class PipelineCacheFile
{
    /// <summary>Bytes of the header that begins the data of every driver: VkPipelineCacheHeaderVersionOne.</summary>
    internal const int HeaderBytes = 32;

    /// <summary>Ends the name of an empty file: the driver keeps elsewhere what it compiled, if it keeps it.</summary>
    internal const string MarkExtension = ".compiled";

    const uint HeaderVersionOne = 1;

    readonly string _folder, _name;
    readonly byte[] _header;
    byte[] _loaded = [];

    /// <param name="folder">Made when first written; null: there is no file.</param>
    /// <param name="header">Header of the device's data.</param>
    internal PipelineCacheFile(string folder, byte[] header, uint driverVersion, ReadOnlySpan<byte> spirv)
    {
        _folder = folder;
        _header = header;
        _name = $"{Convert.ToHexStringLower(header.AsSpan(16))}-{driverVersion:x8}-"
            + $"{Convert.ToHexStringLower(SHA256.HashData(spirv))}.pipeline";
    }

    /// <summary>Name of the file, of device, driver and kernel.</summary>
    internal string Name => _name;

    /// <summary>Path of the file; null if there is no folder.</summary>
    internal string FilePath => _folder == null ? null : Path.Combine(_folder, _name);

    /// <summary>Whether the file is there; it may be damaged.</summary>
    internal bool Exists => File.Exists(FilePath);

    /// <summary>Whether a run has compiled the kernel: there is the file, or the mark in its place.</summary>
    internal bool IsKnown => Exists || File.Exists(MarkPath);

    string MarkPath => FilePath + MarkExtension;

    /// <summary>The header of a device's data.</summary>
    /// <param name="uuid">The device's pipelineCacheUUID, 16 bytes.</param>
    internal static byte[] Header(uint vendorId, uint deviceId, ReadOnlySpan<byte> uuid)
    {
        var header = new byte[HeaderBytes];
        uint[] words = [HeaderBytes, HeaderVersionOne, vendorId, deviceId];
        for (int i = 0; i < words.Length; i++)
            BinaryPrimitives.WriteUInt32LittleEndian(header.AsSpan(i * sizeof(uint)), words[i]);
        uuid.CopyTo(header.AsSpan(words.Length * sizeof(uint)));
        return header;
    }

    /// <summary>
    /// Glint's folder in the user's cache folder: $XDG_CACHE_HOME or ~/.cache, on Windows LocalApplicationData. Null if
    /// there is none.
    /// </summary>
    internal static string UserFolder(Func<string, string> environment)
    {
        if (OperatingSystem.IsWindows())
            return Below(Environment.GetFolderPath(Environment.SpecialFolder.LocalApplicationData), "glint");
        // The XDG specification says to ignore a relative path.
        return Below(environment("XDG_CACHE_HOME"), "glint") ?? Below(environment("HOME"), ".cache/glint");
    }

    /// <summary>The driver's data; empty if the file is missing, cannot be read, is damaged or foreign.</summary>
    internal byte[] Load() => _loaded = Read();

    /// <summary>
    /// Replaces the file, unless it has these data or they are only a header, as those of drivers that keep compiled
    /// kernels elsewhere. A folder that cannot be written is no error.
    /// </summary>
    internal void Save(ReadOnlySpan<byte> data)
    {
        if (_folder == null || data.Length <= HeaderBytes || data.SequenceEqual(_loaded))
            return;
        string temporary = $"{FilePath}.{Guid.NewGuid():N}";
        try
        {
            Directory.CreateDirectory(_folder);
            try
            {
                File.WriteAllBytes(temporary, [.. Checksum(data), .. data]);
                File.Move(temporary, FilePath, overwrite: true);
            }
            finally
            {
                File.Delete(temporary);
            }
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
        }
    }

    /// <summary>Notes that the driver has the kernel, if no file says so. A folder that cannot be written is no error.</summary>
    internal void Mark()
    {
        if (_folder == null || IsKnown)
            return;
        try
        {
            Directory.CreateDirectory(_folder);
            File.WriteAllBytes(MarkPath, []);
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
        }
    }

    byte[] Read()
    {
        try
        {
            if (!File.Exists(FilePath))
                return [];
            var bytes = File.ReadAllBytes(FilePath);
            if (bytes.Length <= SHA256.HashSizeInBytes + HeaderBytes)
                return [];
            var data = bytes.AsSpan(SHA256.HashSizeInBytes);
            return data.StartsWith(_header) && bytes.AsSpan().StartsWith(Checksum(data)) ? data.ToArray() : [];
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
            return [];
        }
    }

    // Of the name too, so that a renamed file counts as foreign.
    byte[] Checksum(ReadOnlySpan<byte> data)
    {
        using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        hash.AppendData(Encoding.UTF8.GetBytes(_name));
        hash.AppendData(data);
        return hash.GetHashAndReset();
    }

    static string Below(string folder, string name) =>
        Path.IsPathFullyQualified(folder ?? "") ? Path.Combine(folder, name) : null;
}
