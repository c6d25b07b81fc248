using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// An element of the scattering matrix, named by the received and then the sent polarisation: HV is received in H
    /// and sent in V.
    /// </summary>
    public sealed class Polarisation
    {
        /// <summary>In the order of columns and options.</summary>
        public static readonly IReadOnlyList<Polarisation> All = new[]
        {
            new Polarisation("vv", 0, 0, s => s.VV), new Polarisation("hv", 1, 0, s => s.HV),
            new Polarisation("vh", 0, 1, s => s.VH), new Polarisation("hh", 1, 1, s => s.HH)
        };

        /// <summary>Sent and received in V.</summary>
        public static Polarisation VV => All[0];

        /// <summary>Sent and received in H.</summary>
        public static Polarisation HH => All[3];

        /// <summary>Those that are received as they are sent.</summary>
        public static readonly IReadOnlyList<Polarisation> CoPolar = new[] { VV, HH };

        /// <summary>In the order of arrays: V before H, the sent polarisation changing fastest.</summary>
        public static readonly IReadOnlyList<Polarisation> Matrix = All
            .OrderBy(polarisation => polarisation.Received).ThenBy(polarisation => polarisation.Sent).ToArray();

        readonly Func<ScatteringMatrix, Complex> _element;

        Polarisation(string name, int received, int sent, Func<ScatteringMatrix, Complex> element) =>
            (Name, Received, Sent, _element) = (name, received, sent, element);

        /// <summary>"vv".</summary>
        public string Name { get; }

        /// <summary>Row in the matrix: 0 received in V, 1 in H.</summary>
        public int Received { get; }

        /// <summary>Column in the matrix: 0 sent in V, 1 in H.</summary>
        public int Sent { get; }

        /// <summary>HV or VH.</summary>
        public bool IsCross => Received != Sent;

        /// <summary>Its amplitude, metres.</summary>
        public Complex Of(in ScatteringMatrix s) => _element(s);

        /// <summary>Reads all, or names with commas.</summary>
        /// <returns>In the order of <see cref="All"/>.</returns>
        /// <exception cref="FormatException">A name is unknown or given twice.</exception>
        public static Polarisation[] Read(string text)
        {
            if (text == "all")
                return All.ToArray();
            var names = text.Split(',').Select(name => name.Trim()).ToArray();
            foreach (string name in names)
                if (All.All(known => known.Name != name))
                    throw new FormatException(
                        $"{Values.Shown(name)} is none: must be all, or of vv, hv, vh and hh, such as vv,hh "
                        + "(received before sent)");
            if (names.Distinct().Count() < names.Length)
                throw new FormatException("must have each polarisation once");
            return All.Where(known => names.Contains(known.Name)).ToArray();
        }

        /// <summary>The name.</summary>
        public override string ToString() => Name;
    }
}
