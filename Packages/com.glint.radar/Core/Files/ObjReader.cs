using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Reads a Wavefront OBJ: v, f and usemtl statements. Polygons are cut into a fan about their first corner,
    /// or by clipping ears where they are concave. Triangles of one material are put in a row.
    /// Colours, texture coordinates, normals, groups, material libraries, points,
    /// lines and free-form curves and surfaces are ignored.
    /// </summary>
    sealed class ObjReader
    {
        // Above every vertex count; ten times it still fits a long.
        const long ReferenceCap = 100_000_000_000_000_000;

        static readonly byte[] UseMaterial = Encoding.ASCII.GetBytes("usemtl");

        static readonly HashSet<string> PassedOver = new HashSet<string>(StringComparer.Ordinal)
        {
            "g", "o", "s", "mg", "mtllib", "usemap", "maplib", "lod", "bevel", "c_interp",
            "d_interp", "shadow_obj", "trace_obj", "ctech", "stech",
            "p", "l", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf",
            "parm", "trim", "hole", "scrv", "sp", "end", "con"
        };

        readonly string _path;
        readonly MeshFilePlacement _placement;
        readonly LineReader _lines;
        readonly List<float3> _vertices = new List<float3>();
        readonly List<int> _indices = new List<int>();
        readonly List<Polygon> _polygons = new List<Polygon>();

        // Triangles from an index on have a material; those before the first usemtl have none.
        readonly List<(int firstIndex, string material)> _runs = new List<(int, string)> { (0, null) };

        // A face may precede its vertices, so the largest reference is checked, and polygons are cut, at the end.
        long _largestReference;
        int _largestReferenceLine;

        public ObjReader(Stream stream, string path, MeshFilePlacement placement)
        {
            _path = path;
            _placement = placement;
            _lines = new LineReader(stream, path, joinsContinued: true);
        }

        public MeshFile Read()
        {
            while (_lines.Read())
                ReadStatement(new Tokenizer(_lines.Line));
            if (_largestReference > _vertices.Count)
                throw new GlintException($"{_path}:{_largestReferenceLine}: "
                    + $"the face refers to vertex {_largestReference}, but the file has {_vertices.Count}: "
                    + "it is truncated or damaged; export it again");
            if (_indices.Count == 0)
                throw new GlintException($"{_path}: has no triangles ({_vertices.Count} vertices, no f line); "
                    + "export it as a polygon mesh");
            CutPolygons();
            return GroupByMaterial(_placement.Turn(_indices.ToArray()));
        }

        // Materials in the order in which the file names them first; the triangles of each in the file's order.
        MeshFile GroupByMaterial(int[] indices)
        {
            var grouped = new List<int>(indices.Length);
            var surfaces = new List<MeshFileSurface>();
            foreach (var runs in Enumerable.Range(0, _runs.Count).GroupBy(run => _runs[run].material))
            {
                int first = grouped.Count;
                foreach (int run in runs)
                {
                    int start = _runs[run].firstIndex,
                        end = run + 1 < _runs.Count ? _runs[run + 1].firstIndex : indices.Length;
                    grouped.AddRange(new ArraySegment<int>(indices, start, end - start));
                }
                if (grouped.Count > first)
                    surfaces.Add(new MeshFileSurface(first / 3, runs.Key));
            }
            return new MeshFile(Path.GetFileNameWithoutExtension(_path), _vertices.ToArray(), grouped.ToArray(),
                surfaces.ToArray());
        }

        void ReadStatement(Tokenizer tokens)
        {
            if (tokens.IsComment || !tokens.Next())
                return;
            var keyword = tokens.Current;
            if (keyword.Length == 1 && keyword[0] == 'v')
                ReadVertex(tokens);
            else if (keyword.Length == 1 && keyword[0] == 'f')
                ReadFace(tokens);
            else if (keyword.SequenceEqual(UseMaterial))
                ReadMaterial(tokens);
            else if (keyword.Length != 2 || keyword[0] != 'v'
                || keyword[1] != 't' && keyword[1] != 'n' && keyword[1] != 'p')
                PassOver(keyword);
        }

        void ReadMaterial(Tokenizer tokens)
        {
            var name = new StringBuilder();
            while (!tokens.IsComment && tokens.Next())
                name.Append(name.Length > 0 ? " " : "").Append(Encoding.UTF8.GetString(tokens.Current));
            _runs.Add((_indices.Count, name.Length > 0 ? name.ToString() : null));
        }

        void PassOver(ReadOnlySpan<byte> keyword)
        {
            if (!PassedOver.Contains(Encoding.ASCII.GetString(keyword)))
                throw _lines.Error($"{Bytes.Quote(keyword)} is not an OBJ statement: the file is damaged or not an "
                    + "OBJ; export it again or remove the line");
        }

        void ReadVertex(Tokenizer tokens)
        {
            float x = Coordinate(ref tokens, "x"), y = Coordinate(ref tokens, "y"), z = Coordinate(ref tokens, "z");
            _vertices.Add(_placement.Turn(x, y, z));

            // Ignores up to four numbers: a weight, a colour or both.
            for (int i = 0; !tokens.IsComment && tokens.Next(); i++)
                if (i == 4 || !NumberParser.TryParse(tokens.Current, out _))
                    throw _lines.Error($"{Bytes.Quote(tokens.Current)} does not belong in a vertex: "
                        + "the line is damaged; export the file again");
        }

        float Coordinate(ref Tokenizer tokens, string axis)
        {
            if (tokens.IsComment || !tokens.Next())
                throw _lines.Error($"the vertex has no {axis}: the line is truncated; export the file again");
            if (!NumberParser.TryParse(tokens.Current, out double value))
                throw _lines.Error($"{axis} is {Bytes.Quote(tokens.Current)}, not a finite number; "
                    + "correct the vertex or export the file again");
            float meters = _placement.Scale(value);
            if (float.IsInfinity(meters))
                throw _lines.Error($"{axis} is {Bytes.Quote(tokens.Current)} {_placement.Unit}, "
                    + "more than a float holds (3.4e38 m); correct the vertex or choose another unit");
            return meters;
        }

        void ReadFace(Tokenizer tokens)
        {
            int first = 0, previous = 0, corners = 0;
            for (; !tokens.IsComment && tokens.Next(); corners++)
            {
                int corner = Corner(tokens.Current);
                if (corners == 0)
                    first = corner;
                else if (corners > 1)
                {
                    _indices.Add(first);
                    _indices.Add(previous);
                    _indices.Add(corner);
                }
                previous = corner;
            }
            if (corners < 3)
                throw _lines.Error($"the face has {corners} corners, but needs at least 3: the line is truncated; "
                    + "export the file again");
            if (corners > 3)
                _polygons.Add(new Polygon(_indices.Count - 3 * (corners - 2), corners, _lines.Number));
        }

        void CutPolygons()
        {
            var cutter = new PolygonCutter(_vertices);
            foreach (var polygon in _polygons)
                if (!cutter.TryCut(_indices, polygon.FirstIndex, polygon.Corners - 2))
                    throw new GlintException(
                        $"{_path}:{polygon.Line}: the face of {polygon.Corners} corners cannot be cut into triangles: "
                        + (polygon.Corners > PolygonCutter.MaxCorners
                            ? $"a concave face may have {PolygonCutter.MaxCorners}"
                            : "its outline crosses itself or is folded")
                        + "; correct it or export triangles");
        }

        // v, v/vt, v//vn or v/vt/vn. Vertices count from 1, or backwards from -1, the latest.
        int Corner(ReadOnlySpan<byte> word)
        {
            int at = 0;
            bool negative = word[0] == '-';
            if (negative)
                at++;
            int start = at;
            long number = 0;
            for (; at < word.Length && word[at] >= '0' && word[at] <= '9'; at++)
                number = Math.Min(ReferenceCap, 10 * number + (word[at] - '0'));
            if (at == start || !IsReferenceEnd(word.Slice(at)))
                throw _lines.Error($"{Bytes.Quote(word)} is not a corner of a face: give v, v/vt, "
                    + "v//vn or v/vt/vn in whole numbers");
            if (number == 0)
                throw _lines.Error($"{Bytes.Quote(word)} refers to vertex 0, but OBJ counts from 1; "
                    + "export the file again");

            if (negative && number > _vertices.Count)
                throw _lines.Error($"{Bytes.Quote(word)} counts back over {number} vertices, "
                    + $"but the file has {_vertices.Count} up to here; export it again");
            if (!negative && number > _largestReference)
            {
                _largestReference = number;
                _largestReferenceLine = _lines.Number;
            }
            return (int)(negative ? _vertices.Count - number : number - 1);
        }

        static bool IsReferenceEnd(ReadOnlySpan<byte> text)
        {
            int slashes = 0;
            foreach (byte letter in text)
                if (letter == '/')
                    slashes++;
                else if (letter != '-' && (letter < '0' || letter > '9'))
                    return false;
            return slashes <= 2;
        }

        /// <summary>A face of more than three corners: its fan in the indices, and its line in the file.</summary>
        readonly struct Polygon
        {
            public readonly int FirstIndex, Corners, Line;

            public Polygon(int firstIndex, int corners, int line) =>
                (FirstIndex, Corners, Line) = (firstIndex, corners, line);
        }
    }
}
