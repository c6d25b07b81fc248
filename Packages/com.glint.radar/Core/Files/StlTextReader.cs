using System;
using System.Collections.Generic;
using System.IO;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Reads an ASCII STL word by word, in any letter case and with any line breaks. Several solids become one mesh.
    /// Normals are ignored and need not be numbers. Coinciding corners are not merged: the tracer needs no shared
    /// vertices.
    /// </summary>
    sealed class StlTextReader
    {
        readonly string _path;
        readonly MeshFilePlacement _placement;
        readonly LineReader _lines;
        readonly List<float3> _vertices = new List<float3>();
        int _wordAt, _wordLength;

        public StlTextReader(Stream stream, string path, MeshFilePlacement placement)
        {
            _path = path;
            _placement = placement;
            _lines = new LineReader(stream, path, joinsContinued: false);
        }

        ReadOnlySpan<byte> Word => _lines.Line.Slice(_wordAt, _wordLength);

        /// <summary>
        /// Whether a file that is not a binary STL by its length should be read as text:
        /// it begins with "solid" and no zero byte follows.
        /// </summary>
        public static bool IsText(ReadOnlySpan<byte> head)
        {
            var text = Bytes.StartsWith(head, 0xef, 0xbb, 0xbf) ? head.Slice(3) : head;
            var tokens = new Tokenizer(text);
            return tokens.Next() && Bytes.IsWord(tokens.Current, "solid") && head.IndexOf((byte)0) < 0;
        }

        public MeshFile Read()
        {
            while (TryNext())
            {
                Require("solid");
                SkipLine();
                ReadSolid();
            }
            if (_vertices.Count == 0)
                throw new GlintException($"{_path}: has no triangles (no facet); export the mesh again");

            var indices = new int[_vertices.Count];
            for (int i = 0; i < indices.Length; i++)
                indices[i] = i;
            return new MeshFile(Path.GetFileNameWithoutExtension(_path), _vertices.ToArray(), _placement.Turn(indices));
        }

        void ReadSolid()
        {
            while (true)
            {
                Next("facet or endsolid");
                if (Bytes.IsWord(Word, "endsolid"))
                {
                    SkipLine();
                    return;
                }
                Require("facet");
                ReadFacet();
            }
        }

        void ReadFacet()
        {
            Expect("normal");
            for (int i = 0; i < 3; i++)
                Next("the normal");
            Expect("outer");
            Expect("loop");
            for (int i = 0; i < 3; i++)
            {
                Expect("vertex");
                float x = Coordinate("x"), y = Coordinate("y"), z = Coordinate("z");
                _vertices.Add(_placement.Turn(x, y, z));
            }
            Expect("endloop");
            Expect("endfacet");
        }

        float Coordinate(string axis)
        {
            Next(axis);
            if (!NumberParser.TryParse(Word, out double value))
                throw _lines.Error($"{axis} is {Bytes.Quote(Word)}, not a finite number; "
                    + "correct the vertex or export the file again");
            float meters = _placement.Scale(value);
            if (float.IsInfinity(meters))
                throw _lines.Error($"{axis} is {Bytes.Quote(Word)} {_placement.Unit}, "
                    + "more than a float holds (3.4e38 m); correct the vertex or choose another unit");
            return meters;
        }

        void Expect(string word)
        {
            Next(word);
            Require(word);
        }

        void Require(string word)
        {
            if (!Bytes.IsWord(Word, word))
                throw _lines.Error($"{Bytes.Quote(Word)} is where an STL has {word}: "
                    + "the file is damaged; export it again");
        }

        void Next(string expected)
        {
            if (!TryNext())
                throw _lines.Error($"the file ends where {expected} should follow: it is truncated; export it again");
        }

        bool TryNext()
        {
            _wordAt = Tokenizer.StartOf(_lines.Line, _wordAt + _wordLength);
            while (_wordAt == _lines.Line.Length)
            {
                if (!_lines.Read())
                    return false;
                _wordAt = Tokenizer.StartOf(_lines.Line, 0);
            }
            _wordLength = Tokenizer.EndOf(_lines.Line, _wordAt) - _wordAt;
            return true;
        }

        void SkipLine() => (_wordAt, _wordLength) = (_lines.Line.Length, 0);
    }
}
