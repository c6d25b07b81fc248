using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A ray that lights a sea after other surfaces have reflected it.</summary>
    public struct SeaLight
    {
        /// <summary>Of the scene, and triangle of its mesh.</summary>
        public int Instance, Triangle;

        /// <summary>Direction of the ray, the polarisations sent as mirrored with it, and the facet's normal.</summary>
        public double3 Direction, V, H, Normal;

        /// <summary>Fields along V and H for V sent, and for H sent, without spread.</summary>
        public Complex SentVAlongV, SentVAlongH, SentHAlongV, SentHAlongH;

        /// <summary>Section of the ray's tube where the field has no spread, and here; m2.</summary>
        public double StartSection, Section;

        /// <summary>Whether the radar sees the place.</summary>
        public bool IsSeen;

        /// <summary>The radar from the place: direction, polarisations, strength relative to the phase centre's.</summary>
        public double3 ToRadar, RadarV, RadarH;

        /// <inheritdoc cref="ToRadar"/>
        public double Strength;

        /// <summary>The way from the place to the radar, and that of the ray, less those of the phase centre; m.</summary>
        public double NearerDirect, NearerByRay;
    }

    /// <summary>
    /// The diffuse echo that ships and sea make together: the sea scatters what a ship has reflected to it towards the radar,
    /// the same path the other way round, and what returns by way of the ship both times. The sea may have mirrored the wave
    /// to the ship. Rays carry the power, so that the sum is that over the lit sea whatever their number.
    /// </summary>
    public sealed class ShipSeaEcho
    {
        // Largest focusing of a tube that is believed: at a line where rays meet optics are infinite.
        const double MaxFocus = 10;

        // Of the ripples that scatter between ship and radar, and of those that scatter back to the ship: independent of
        // those that scatter back to the radar.
        const uint BetweenSeed = 0x5bd1e995, BackSeed = 0x9e3779b9;

        readonly CrossSectionPose _pose;
        readonly Dictionary<int, (RadarSea Sea, int2 Tile, uint Seed)> _tiles =
            new Dictionary<int, (RadarSea, int2, uint)>();
        readonly Dictionary<SeaClutter, BistaticScattering> _scattering = new Dictionary<SeaClutter, BistaticScattering>();
        readonly Dictionary<(int Instance, int Triangle), Lit> _lit = new Dictionary<(int, int), Lit>();

        /// <summary>The echo of the seas of a pose.</summary>
        public ShipSeaEcho(CrossSectionPose pose)
        {
            _pose = pose;
            for (int number = 0; number < pose.Scene.Seas.Count; number++)
            {
                var sea = pose.Scene.Seas[number];
                foreach (var tile in sea.Tiles)
                    _tiles[tile.Instance] = (sea, tile.Number, Speckle.SeedOf(sea.Clutter.Seed, number));
            }
        }

        // Mean cross sections of a facet, VV, HV and HH, and the ways of their paths less those of the phase centre.
        sealed class Lit
        {
            public double3 Between, Back;
            public double NearerBetween, NearerBack;
        }

        /// <summary>Adds a light.</summary>
        /// <param name="number">Of the ray: it draws the slope of the facet's ripples.</param>
        public void Add(in SeaLight light, int number)
        {
            if (!_tiles.TryGetValue(light.Instance, out var place))
                return;
            var clutter = place.Sea.Clutter;
            double cosine = -math.dot(light.Direction, light.Normal);
            if (!(cosine > 0))
                return;
            double area = light.StartSection / cosine,
                focus = Math.Min(MaxFocus, light.StartSection / Math.Max(light.Section, double.Epsilon));
            double3 back = area * focus * BackOf(light, clutter, number),
                between = light.IsSeen ? area * light.Strength * light.Strength * BetweenOf(light, clutter, number) : 0;
            if (!_lit.TryGetValue((light.Instance, light.Triangle), out var lit))
                _lit.Add((light.Instance, light.Triangle), lit = new Lit
                {
                    NearerBetween = light.NearerDirect + light.NearerByRay, NearerBack = 2 * light.NearerByRay
                });
            lit.Between += between;
            lit.Back += back;
        }

        /// <summary>The echo at each sample of the pose: fields with speckle, and mean cross sections.</summary>
        public ClutterEcho[] Echoes()
        {
            var facets = _lit.OrderBy(it => it.Key.Instance).ThenBy(it => it.Key.Triangle).ToArray();
            var echoes = new ClutterEcho[_pose.Samples];
            (double, double) now = (0, double.NaN);
            var speckles = new (Complex Between, Complex Back)[facets.Length];
            for (int sample = 0; sample < echoes.Length; sample++)
            {
                // Samples of a band have the speckle of its middle.
                var at = (Frequency: _pose.BandCentre ?? _pose.FrequencyOf(sample), Time: _pose.TimeOf(sample));
                if (!at.Equals(now))
                    speckles = Array.ConvertAll(facets, facet => SpecklesOf(facet.Key, at.Frequency, at.Time));
                now = at;
                double waveNumber = 2 * Math.PI / Signal.Wavelength(_pose.PhaseFrequencyOf(sample));
                for (int i = 0; i < facets.Length; i++)
                {
                    var lit = facets[i].Value;
                    echoes[sample] += EchoOf(lit.Between, lit.NearerBetween, speckles[i].Between, waveNumber)
                        + EchoOf(lit.Back, lit.NearerBack, speckles[i].Back, waveNumber);
                }
            }
            return echoes;
        }

        (Complex, Complex) SpecklesOf((int Instance, int Triangle) facet, double frequency, double time)
        {
            var (sea, tile, seed) = _tiles[facet.Instance];
            double times = (sea.Clutter.Time + time) / sea.Clutter.CoherenceTimeAt(frequency);
            var cell = new int2(facet.Triangle, tile.x << 16 | tile.y & 0xffff);
            return (Speckle.Between(cell, seed ^ BetweenSeed, times).Approaching,
                Speckle.Between(cell, seed ^ BackSeed, times).Approaching);
        }

        static ClutterEcho EchoOf(double3 sigma, double nearer, Complex speckle, double waveNumber)
        {
            var field = speckle * Complex.FromPolarCoordinates(1, waveNumber * nearer);
            var crossed = Math.Sqrt(sigma.y) * field;
            return new ClutterEcho
            {
                S = new ScatteringMatrix
                {
                    VV = Math.Sqrt(sigma.x) * field, HV = crossed, VH = crossed, HH = Math.Sqrt(sigma.z) * field
                },
                SigmaVV = sigma.x, SigmaHV = sigma.y, SigmaHH = sigma.z
            };
        }

        BistaticScattering ScatteringOf(SeaClutter clutter)
        {
            if (!_scattering.TryGetValue(clutter, out var scattering))
                _scattering.Add(clutter, scattering = new BistaticScattering(_pose.CoefficientFrequency,
                    clutter.Water.At(_pose.CoefficientFrequency).permittivity, clutter.ShortWaves.Spectrum.Density));
            return scattering;
        }

        // Both ways round: their fields are equal for equal polarisations.
        double3 BetweenOf(in SeaLight light, SeaClutter clutter, int number)
        {
            var (byShip, direct) = (ByShip(light), Direct(light));
            if (clutter.BreakingFacets[light.Triangle])
                return BistaticScattering.BreakingPower(-light.Direction, light.ToRadar) * PowersOf((received, sent) =>
                    BistaticScattering.MirroredWhole(direct[received], byShip[sent])
                        + BistaticScattering.MirroredWhole(byShip[received], direct[sent]));
            var scattering = ScatteringOf(clutter);
            double3 normal = Tilted(light.Normal, clutter, number), towards = -light.Direction;
            double ripples = scattering.RipplePower(towards, light.ToRadar, normal, clutter.Wind, GrowthOf(light, clutter)),
                mirrors = MirrorsOf(light, clutter, light.ToRadar);
            double3 coupled = ripples == 0 ? 0 : ripples * PowersOf((received, sent) =>
                    scattering.Coupling(direct[received], byShip[sent], normal)
                        + scattering.Coupling(byShip[received], direct[sent], normal)),
                mirrored = mirrors == 0 ? 0 : mirrors * PowersOf((received, sent) =>
                    scattering.Mirrored(direct[received], byShip[sent])
                        + scattering.Mirrored(direct[sent], byShip[received]));
            return coupled + mirrored;
        }

        double3 BackOf(in SeaLight light, SeaClutter clutter, int number)
        {
            var byShip = ByShip(light);
            double3 towards = -light.Direction;
            if (clutter.BreakingFacets[light.Triangle])
                return BistaticScattering.BreakingPower(towards, towards) * PowersOf((received, sent) =>
                    BistaticScattering.MirroredWhole(byShip[received], byShip[sent]));
            var scattering = ScatteringOf(clutter);
            double3 normal = Tilted(light.Normal, clutter, number);
            double ripples = scattering.RipplePower(towards, towards, normal, clutter.Wind, GrowthOf(light, clutter)),
                mirrors = MirrorsOf(light, clutter, towards);
            double3 coupled = ripples == 0 ? 0 : ripples * PowersOf((received, sent) =>
                    scattering.Coupling(byShip[received], byShip[sent], normal)),
                mirrored = mirrors == 0 ? 0 : mirrors * PowersOf((received, sent) =>
                    scattering.Mirrored(byShip[received], byShip[sent]));
            return coupled + mirrored;
        }

        // Of fields by the polarisations received and sent, 0: V, 1: H. VV, HV and HH.
        static double3 PowersOf(Func<int, int, Complex> field) =>
            new double3(Squared(field(0, 0)), Squared(field(1, 0)), Squared(field(1, 1)));

        // The part of the mirrored power that unresolved heights take from the mirrored field.
        double MirrorsOf(in SeaLight light, SeaClutter clutter, double3 to)
        {
            var table = clutter.TableAt(_pose.CoefficientFrequency);
            double density = BistaticScattering.MirrorDensity(-light.Direction, to, light.Normal, clutter.Wind,
                table.Unresolved, table.Covariance);
            double loss = RoughnessLoss.MillerBrown(2 * Math.PI / Signal.Wavelength(_pose.CoefficientFrequency)
                * clutter.ShortWaves.Height * -math.dot(light.Direction, light.Normal));
            return density * (1 - loss * loss);
        }

        // A slope of the waves that the facet leaves out.
        double3 Tilted(double3 normal, SeaClutter clutter, int number)
        {
            var random = new SplitMix64((ulong)number << 32 ^ clutter.Seed);
            double size = Math.Sqrt(-2 * Math.Log(random.NextAboveZero()));
            double2 slope = size * math.sqrt(clutter.TableAt(_pose.CoefficientFrequency).TiltVariance);
            var (sine, cosine) = PortableMath.SinCos(random.NextAboveZero());
            double3 wind = clutter.Wind, across = new double3(-wind.z, 0, wind.x);
            return math.normalize(normal - Math.Abs(normal.y) * (slope.x * cosine * wind + slope.y * sine * across));
        }

        static Func<double, double, double> GrowthOf(in SeaLight light, SeaClutter clutter)
        {
            double wind = clutter.LogWinds[light.Triangle / 2];
            return (waveNumber, cosine) => Math.Exp(wind * clutter.ShortWaves.WindExponent(waveNumber, cosine));
        }

        static SurfaceWave[] ByShip(in SeaLight light) => new[]
        {
            new SurfaceWave(-light.Direction, light.V, light.H, light.SentVAlongV, light.SentVAlongH),
            new SurfaceWave(-light.Direction, light.V, light.H, light.SentHAlongV, light.SentHAlongH)
        };

        static SurfaceWave[] Direct(in SeaLight light) => new[]
        {
            new SurfaceWave(light.ToRadar, light.RadarV, light.RadarH, 1, 0),
            new SurfaceWave(light.ToRadar, light.RadarV, light.RadarH, 0, 1)
        };

        static double Squared(Complex value) => value.Real * value.Real + value.Imaginary * value.Imaginary;
    }
}
