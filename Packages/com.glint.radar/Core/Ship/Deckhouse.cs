using System;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The lower two storeys, the deckhouse and on it what carries bridge and funnel:
    /// upright flat fronts and ends, sides that lean inwards.
    /// </summary>
    sealed class Deckhouse
    {
        // Parts reach so far into each other, metres: no two faces lie in one plane.
        public const double Overlap = 0.05;

        /// <summary>Where the deckhouse is as wide as it gets, of the way from the middle to its front.</summary>
        public const double Shoulder = 0.62;

        // How far the sides lean inwards, of their height.
        const double Lean = 0.14;

        readonly ShipSettings _settings;
        readonly Hull _hull;

        public Deckhouse(in ShipSettings settings, Hull hull)
        {
            _settings = settings;
            _hull = hull;
        }

        /// <summary>
        /// Heights of the roofs of the deckhouse and, on it,
        /// of the house below the bridge and of the casing below the funnel.
        /// </summary>
        public double LowerRoof => _settings.Freeboard + _settings.Forecastle + _settings.StoreyHeight;

        public double UpperRoof => LowerRoof + _settings.StoreyHeight;

        public double CasingRoof => UpperRoof + 0.5;

        /// <summary>Half their widths, that of the deckhouse amidships. Beside the casing stand life boats.</summary>
        public double LowerHalfWidth => HalfWidth(0);

        public double UpperHalfWidth => HalfWidth(UpperFront) - Lean * _settings.StoreyHeight - 0.1;

        public double CasingHalfWidth => LowerHalfWidth - 2.4;

        /// <summary>Where the upper house begins, where the casing takes over, and where that ends.</summary>
        public double UpperFront => Shoulder * _settings.HouseFrontZ;

        public double CasingFront => UpperFront + 2.7 * UpperHalfWidth;

        public double CasingAft => 0.7 * _settings.HouseAftZ;

        public ShipPart[] Build()
        {
            double front = _settings.HouseFrontZ, aft = _settings.HouseAftZ, onRoof = LowerRoof - Overlap;
            double quarterdeck = _settings.Freeboard - Overlap, foredeck = quarterdeck + _settings.Forecastle;
            return new[]
            {
                // Its foot stays below the deck, which slopes from the shoulder to the end, and inside the hull.
                Storey(LowerRoof, At(front, foredeck), At(UpperFront, foredeck),
                    At(0, quarterdeck), At(aft, quarterdeck)),
                Storey(UpperRoof, new double3(UpperHalfWidth, onRoof, UpperFront),
                    new double3(UpperHalfWidth, onRoof, CasingFront)),
                Storey(CasingRoof, new double3(CasingHalfWidth, onRoof, CasingFront - Overlap),
                    new double3(CasingHalfWidth, onRoof, CasingAft)),
            };
        }

        double3 At(double z, double foot) => new double3(HalfWidth(z), foot, z);

        // (Half the width at the roof, height of the foot, z) from front to end.
        static ShipPart Storey(double roof, params double3[] stations)
        {
            double3[] Outline(Func<double3, double3> starboard)
            {
                var outline = new double3[2 * stations.Length];
                for (int i = 0; i < stations.Length; i++)
                {
                    double3 point = starboard(stations[i]);
                    outline[i] = point;
                    outline[outline.Length - 1 - i] = new double3(-point.x, point.yz);
                }
                return outline;
            }
            return ShipPart.Block(Outline(at => new double3(at.x + Lean * (roof - at.y), at.yz)),
                Outline(at => new double3(at.x, roof, at.z)));
        }

        // Leaves side decks to walk on.
        double HalfWidth(double z) => 0.82 * _hull.DeckHalfWidth(z) - Lean * _settings.StoreyHeight;
    }
}
