using System;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The lower two storeys: the deckhouse, and on it the house below the bridge and the casing below the funnel.
    /// Fronts and ends are vertical and flat, sides lean inwards.
    /// </summary>
    sealed class Deckhouse
    {
        // Overlap of parts, metres, so that no two faces are coplanar.
        public const double Overlap = 0.05;

        /// <summary>
        /// Position of the deckhouse's full width, as a fraction of the way from its middle to its front.
        /// </summary>
        public const double Shoulder = 0.62;

        // Inward lean of the sides, as a fraction of their height.
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

        /// <summary>Half the widths of these; of the deckhouse amidships. Life boats are beside the casing.</summary>
        public double LowerHalfWidth => HalfWidth(0);

        public double UpperHalfWidth => HalfWidth(UpperFront) - Lean * _settings.StoreyHeight - 0.1;

        public double CasingHalfWidth => LowerHalfWidth - 2.4;

        /// <summary>z of the upper house's front, of the casing's front, and of its end.</summary>
        public double UpperFront => Shoulder * _settings.HouseFrontZ;

        public double CasingFront => UpperFront + 2.7 * UpperHalfWidth;

        public double CasingAft => 0.7 * _settings.HouseAftZ;

        public ShipPart[] Build()
        {
            double front = _settings.HouseFrontZ, aft = _settings.HouseAftZ, onRoof = LowerRoof - Overlap;
            double quarterdeck = _settings.Freeboard - Overlap, foredeck = quarterdeck + _settings.Forecastle;
            return new[]
            {
                // The foot is below the deck, which slopes from the shoulder to the end, and inside the hull.
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

        // Narrower than the deck, which leaves side decks.
        double HalfWidth(double z) => 0.82 * _hull.DeckHalfWidth(z) - Lean * _settings.StoreyHeight;
    }
}
