using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text.RegularExpressions;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>Fields of structs that C# wrote, as a kernel called Unpack reads them.</summary>
    sealed class ShaderFields : IDisposable
    {
        readonly ComputeShader _shader;
        readonly int _kernel;
        readonly List<GraphicsBuffer> _buffers = new List<GraphicsBuffer>();

        public ShaderFields(ComputeShader shader) => (_shader, _kernel) = (shader, shader.FindKernel("Unpack"));

        /// <summary>The second element of a buffer, which a wrong stride would miss.</summary>
        public void Bind<T>(string name, T second) where T : struct
        {
            var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 2, Marshal.SizeOf<T>());
            _buffers.Add(buffer);
            buffer.SetData(new[] { default, second });
            _shader.SetBuffer(_kernel, name, buffer);
        }

        /// <summary>The words that the kernel wrote.</summary>
        public uint[] Unpack(int count)
        {
            var fields = new GraphicsBuffer(GraphicsBuffer.Target.Structured, count, sizeof(uint));
            _buffers.Add(fields);
            _shader.SetBuffer(_kernel, "_Fields", fields);
            _shader.Dispatch(_kernel, 1, 1, 1);
            var values = new uint[count];
            fields.GetData(values);
            return values;
        }

        public void Dispose() => _buffers.ForEach(buffer => buffer.Dispose());
    }

    /// <summary>Constants of a shader file of the package.</summary>
    static class ShaderConstants
    {
        /// <summary>All constants that the file declares outside of functions, by name.</summary>
        public static Dictionary<string, double> Of(string file)
        {
            string path = Path.Combine(Application.dataPath, "../Packages/com.glint.radar/Shaders", file);
            var constants = new Dictionary<string, double>();
            foreach (string line in File.ReadLines(path).Where(line => line.StartsWith("static const")))
            {
                var match = Regex.Match(line, @"^static const (uint|float) (\w+) = ([^;]+);");
                string text = match.Groups[3].Value;
                constants.Add(match.Groups[2].Value, constants.TryGetValue(text, out double known) ? known : Value(text));
            }
            return constants;
        }

        static double Value(string text) => text.StartsWith("0x")
            ? uint.Parse(text.Substring(2), NumberStyles.HexNumber)
            : double.Parse(text, CultureInfo.InvariantCulture);
    }
}
