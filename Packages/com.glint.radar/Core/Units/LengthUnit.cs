using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Core
{
    /// <summary>The unit of a mesh file's coordinates.</summary>
    public sealed class LengthUnit
    {
        static readonly LengthUnit[] Units =
        {
            new LengthUnit("m", 1), new LengthUnit("dm", 0.1), new LengthUnit("cm", 0.01),
            new LengthUnit("mm", 0.001), new LengthUnit("um", 1e-6),
            new LengthUnit("km", 1000), new LengthUnit("in", 0.0254), new LengthUnit("ft", 0.3048)
        };

        LengthUnit(string name, double meters) =>
            (Name, Meters) = (name, meters);

        /// <summary>All units.</summary>
        public static IReadOnlyList<LengthUnit> All => Units;

        /// <summary>Symbol: "mm".</summary>
        public string Name { get; }

        /// <summary>Metres in one unit.</summary>
        public double Meters { get; }

        /// <summary>The unit of a symbol.</summary>
        /// <exception cref="FormatException">The unit is unknown; the message lists the units.</exception>
        public static LengthUnit Parse(string text) => Units.FirstOrDefault(unit => unit.Name == text)
            ?? throw new FormatException($"must be one of {string.Join(", ", Units.Select(unit => unit.Name))}");

        /// <summary>The symbol.</summary>
        public override string ToString() => Name;
    }
}
