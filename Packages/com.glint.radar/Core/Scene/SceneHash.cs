using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using System.Security.Cryptography;

namespace Glint.Core
{
    /// <summary>
    /// Tells the content of scenes apart, from run to run and machine to machine:
    /// SHA-256 over numbers as they lie in memory, little-endian.
    /// </summary>
    sealed class SceneHash : IDisposable
    {
        // Of 64 digits: enough that two scenes never have the same.
        const int Digits = 32;

        readonly IncrementalHash _hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);

        /// <summary>Takes in meshes and places, each mesh once.</summary>
        public void Add(RadarScene scene)
        {
            var meshes = new Dictionary<TriangleMesh, int>();
            foreach (var instance in scene.Instances)
            {
                if (!meshes.TryGetValue(instance.Mesh, out int number))
                {
                    meshes.Add(instance.Mesh, number = meshes.Count);
                    Add(instance.Mesh.Vertices);
                    Add(instance.Mesh.Indices);
                }
                Add(new[] { number });
                Add(new[] { instance.ToWorld });
            }
            // Scenes of perfect conductors alone keep the hash that they had before there were surfaces.
            if (scene.Surfaces.Count == 1)
                return;
            foreach (var instance in scene.Instances)
                Add(instance.Ranges.SelectMany(range => new[] { range.FirstTriangle, range.Surface }).ToArray());
            foreach (var surface in scene.Surfaces)
                Add(surface.Name.ToCharArray());
        }

        /// <summary>Takes in numbers or structs of numbers, and how many they are.</summary>
        public void Add<T>(T[] values) where T : struct
        {
            _hash.AppendData(BitConverter.GetBytes(values.Length));
            _hash.AppendData(MemoryMarshal.AsBytes(new ReadOnlySpan<T>(values)));
        }

        /// <summary>The hash of all that was added, in hexadecimal digits; then it is empty again.</summary>
        public string Text() =>
            BitConverter.ToString(_hash.GetHashAndReset()).Replace("-", "").ToLowerInvariant().Substring(0, Digits);

        public void Dispose() => _hash.Dispose();
    }
}
