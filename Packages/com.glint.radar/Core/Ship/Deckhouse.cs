using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The first storey: upright flat front and end, sides that lean inwards.</summary>
    sealed class Deckhouse
    {
        // Parts of different solids reach so far into each other, metres: no two faces lie in one plane.
        public const double Overlap = 0.05;

        // How far the sides lean inwards, of their height.
        const double Lean = 0.14;

        readonly ShipSettings _settings;
        readonly Hull _hull;

        public Deckhouse(in ShipSettings settings, Hull hull)
        {
            _settings = settings;
            _hull = hull;
        }

        public double Roof => _settings.Freeboard + _settings.StoreyHeight;

        /// <summary>Half the width of the roof amidships.</summary>
        public double RoofHalfWidth => HalfWidth(0) - Lean * (_settings.StoreyHeight + Overlap);

        public ShipPart Build()
        {
            double front = -_settings.HouseFront, shoulder = 0.4 * front, aft = _settings.HouseAft, foot = _settings.Freeboard - Overlap;
            double[] z = { front, shoulder, aft };
            double3[] Outline(double height, double inwards)
            {
                var outline = new double3[2 * z.Length];
                for (int i = 0; i < z.Length; i++)
                {
                    outline[i] = new double3(HalfWidth(z[i]) - inwards, height, z[i]);
                    outline[outline.Length - 1 - i] = new double3(-outline[i].x, height, z[i]);
                }
                return outline;
            }
            return ShipPart.Block(Outline(foot, 0), Outline(Roof, Lean * (Roof - foot)));
        }

        // Side decks are left free to walk on.
        double HalfWidth(double z) => 0.8 * _hull.DeckHalfWidth(z);
    }
}
