using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>
    /// A square of tubes, the piece of work of one core: divides them at borders, level by level. A ring of tubes
    /// around the square is divided too, and belongs to other blocks.
    /// </summary>
    sealed class TubeBlock
    {
        /// <summary>Undivided tubes along the edge of a block.</summary>
        public const int Cells = 16;

        readonly TubeTracer _tracer;
        readonly TubeBorder _border;
        readonly double2 _corner;
        readonly double _size;

        // Paths of the tubes of a level and of the level above, by position in half tubes of that level: corners are at
        // even positions, centres at odd ones.
        Dictionary<(int, int), TubePath> _paths = new Dictionary<(int, int), TubePath>(), _pathsAbove;
        int _depth;

        /// <param name="corner">Lowest corner of the block on the grid, metres.</param>
        /// <param name="size">Edge of an undivided tube, metres.</param>
        public TubeBlock(TubeTracer tracer, TubeBorder border, double2 corner, double size)
        {
            _tracer = tracer;
            _border = border;
            _corner = corner;
            _size = size;
        }

        /// <summary>Divides the tubes, and adds each that is not divided further.</summary>
        public void Add(int maxDepth, TubeField field, ScatteringMatrix[,] sums)
        {
            var cells = new List<(int x, int y)>();
            for (int y = -1; y <= Cells; y++)
                for (int x = -1; x <= Cells; x++)
                    cells.Add((x, y));
            for (_depth = 0; cells.Count > 0; _depth++)
            {
                _pathsAbove = _paths;
                _paths = new Dictionary<(int, int), TubePath>();
                var borders = new HashSet<(int, int)>();
                if (_depth < maxDepth)
                    borders.UnionWith(cells.Where(HasBorder));
                var divided = new List<(int, int)>();
                foreach (var cell in cells)
                {
                    if (IsBeside(cell, borders))
                        divided.AddRange(Parts(cell).Where(part => IsWithin(part, _depth + 1, 1)));
                    else if (IsWithin(cell, _depth, 0))
                        field.Add(PathAt(2 * cell.x + 1, 2 * cell.y + 1), _size / (1 << _depth), sums);
                }
                cells = divided;
            }
        }

        // A corner of a face can reach into a tube between its rays: then a border runs through its neighbour.
        static bool IsBeside((int x, int y) cell, HashSet<(int, int)> borders)
        {
            if (borders.Count > 0)
                for (int y = cell.y - 1; y <= cell.y + 1; y++)
                    for (int x = cell.x - 1; x <= cell.x + 1; x++)
                        if (borders.Contains((x, y)))
                            return true;
            return false;
        }

        static IEnumerable<(int x, int y)> Parts((int x, int y) cell)
        {
            for (int i = 0; i < 4; i++)
                yield return (2 * cell.x + i % 2, 2 * cell.y + i / 2);
        }

        // Whether a tube of a level belongs to the block, or to a ring of tubes around it.
        static bool IsWithin((int x, int y) cell, int depth, int ring)
        {
            int end = (Cells << depth) + ring;
            return cell.x >= -ring && cell.x < end && cell.y >= -ring && cell.y < end;
        }

        bool HasBorder((int x, int y) cell)
        {
            int x = 2 * cell.x + 1, y = 2 * cell.y + 1;
            var centre = PathAt(x, y);
            double half = _size / (2 << _depth);
            for (int i = 0; i < 4; i++)
            {
                int2 step = new int2(2 * (i % 2) - 1, 2 * (i / 2) - 1);
                if (_border.IsBetween(centre, PathAt(x + step.x, y + step.y), half * (double2)step))
                    return true;
            }
            return false;
        }

        TubePath PathAt(int x, int y)
        {
            if (_paths.TryGetValue((x, y), out var path))
                return path;
            if (x % 2 != 0 || y % 2 != 0 || !_pathsAbove.TryGetValue((x / 2, y / 2), out path))
                path = _tracer.Trace(_corner + _size / (2 << _depth) * new double2(x, y));
            _paths[(x, y)] = path;
            return path;
        }
    }
}
