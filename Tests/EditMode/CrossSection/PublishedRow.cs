using System.Globalization;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// A published value of a cross section: target, frequency in Hz, theta and phi to the radar, theta and phi to the
    /// receiver in degrees, range in metres (0: far), bounces (only-N: the N-th alone), material, edges, polarisation,
    /// dBsm, tolerance in dB. Theta is from the vertical and phi from x towards y of right-handed axes with z up.
    /// </summary>
    sealed class PublishedRow
    {
        const string OneBounce = "only-";

        readonly string[] _fields;

        public PublishedRow(string text) => _fields = text.Split(' ');

        public override string ToString() => string.Join(" ", _fields);

        public string Target => _fields[0];

        /// <summary>Theta and phi to the radar, and to another receiver, degrees.</summary>
        public string Directions => $"{_fields[2]}, {_fields[3]}"
            + (Receiver == (_fields[2], _fields[3]) ? "" : $" to {_fields[4]}, {_fields[5]}");

        /// <summary>What else the value depends on.</summary>
        public string[] Conditions => new[]
        {
            Target, (Number(1) / 1e9).ToString("0.######", CultureInfo.InvariantCulture) + " GHz",
            _fields[6] == "0" ? "far field" : $"at {_fields[6]} m",
            IsOneBounce ? $"bounce {Bounces} alone" : Bounces == 1 ? "1 bounce" : $"up to {Bounces} bounces",
            MaterialText(),
            HasEdges ? "fringe fields" : "no fringe fields"
        };

        /// <summary>All but receiver, polarisation, value and tolerance: rows with the same share a trace.</summary>
        public string Wave => string.Join(" ", _fields.Where((_, i) => i < 4 || i >= 6 && i < 10));

        public (string, string) Receiver => (_fields[4], _fields[5]);

        public Polarisation Polarisation => Polarisation.Read(_fields[10].ToLowerInvariant())[0];

        public double Dbsm => Number(11);

        public double ToleranceDb => Number(12);

        bool IsOneBounce => _fields[7].StartsWith(OneBounce, System.StringComparison.Ordinal);

        int Bounces => int.Parse(IsOneBounce ? _fields[7].Substring(OneBounce.Length) : _fields[7],
            CultureInfo.InvariantCulture);

        bool HasEdges => _fields[9] == "1";

        public CrossSectionPose Pose() => new CrossSectionPose
        {
            Scene = new RadarScene(CrossSectionTargets.Named(_fields[0])) { Surfaces = new[] { Material() } },
            Radar = Aspect(Number(2), Number(3)), Receivers = new[] { ReceiverAspect() },
            Frequencies = new[] { Number(1) }, Range = Number(6) > 0 ? Number(6) : double.PositiveInfinity,
            MaxBounces = Bounces, OnlyBounce = IsOneBounce ? Bounces : 0, HasEdges = HasEdges
        };

        public RadarAspect ReceiverAspect() => Aspect(Number(4), Number(5));

        /// <summary>
        /// The aspect of a direction in degrees. Axes with z up become Unity's, (x, y, z) to (x, z, y); up is against
        /// the unit vector of theta, right along that of phi.
        /// </summary>
        public static RadarAspect Aspect(double thetaDegrees, double phiDegrees)
        {
            double theta = radians(thetaDegrees), phi = radians(phiDegrees);
            double sinT = sin(theta), cosT = cos(theta), sinP = sin(phi), cosP = cos(phi);
            return new RadarAspect(double3(sinT * cosP, cosT, sinT * sinP),
                double3(-cosT * cosP, sinT, -cosT * sinP), double3(-sinP, 0, cosP));
        }

        // metal: a layer of e' - j e'', mu' - j mu'' and a thickness in metres on metal; open: a half-space.
        SurfaceMaterial Material()
        {
            if (_fields[8] == "-")
                return SurfaceMaterial.PerfectConductor;
            var parts = _fields[8].Split(',');
            var values = parts.Skip(1).Select(part => double.Parse(part, CultureInfo.InvariantCulture)).ToArray();
            var medium = Medium.Constant(values[0], values[1], values[2], values[3]);
            return parts[0] == "metal"
                ? new SurfaceMaterial("layer", new[] { new MaterialLayer(medium, values[4]) })
                : new SurfaceMaterial("half-space", halfSpace: medium);
        }

        string MaterialText()
        {
            var parts = _fields[8].Split(',');
            if (parts.Length == 1)
                return "metal";
            string medium = $"e = {parts[1]} - j {parts[2]}, mu = {parts[3]} - j {parts[4]}";
            return parts[0] == "metal" ? $"{parts[5]} m of {medium} on metal" : $"half-space of {medium}";
        }

        double Number(int field) => double.Parse(_fields[field], CultureInfo.InvariantCulture);
    }
}
