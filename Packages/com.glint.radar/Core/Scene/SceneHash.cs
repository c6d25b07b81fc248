using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using System.Security.Cryptography;

namespace Glint.Core
{
    /// <summary>
    /// Identifies the content of a scene across runs and machines: SHA-256 over the bytes of its numbers,
    /// little-endian.
    /// </summary>
    sealed class SceneHash : IDisposable
    {
        // Of 64: 128 bits make collisions negligible.
        const int Digits = 32;

        readonly IncrementalHash _hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);

        /// <summary>Adds meshes and transforms, each mesh once.</summary>
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

        /// <summary>Adds numbers or structs of numbers, and their count.</summary>
        public void Add<T>(T[] values) where T : struct
        {
            _hash.AppendData(BitConverter.GetBytes(values.Length));
            _hash.AppendData(MemoryMarshal.AsBytes(new ReadOnlySpan<T>(values)));
        }

        /// <summary>The hash of everything added, in hexadecimal digits; resets the hash.</summary>
        public string Text() =>
            BitConverter.ToString(_hash.GetHashAndReset()).Replace("-", "").ToLowerInvariant().Substring(0, Digits);

        public void Dispose() => _hash.Dispose();
    }
}
