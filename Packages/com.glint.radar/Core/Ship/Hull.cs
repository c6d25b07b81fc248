using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The hull: round sides that flare towards the bow, a raked stem, a flat transom, and a level deck with sheer
    /// towards the bow.
    /// </summary>
    sealed class Hull
    {
        // Positions of the full width and of the keel's rise towards the stern, as fractions of the length from the
        // stern.
        const double Widest = 0.42, KeelRise = 0.45;

        // Steps across the flat deck and the flat transom.
        const int Across = 6;

        // Length of level deck before the deckhouse, metres: a ray at a grazing angle of 10 degrees that returns by the
        // house front hits level deck.
        const double LevelBeforeHouse = 4;

        readonly ShipSettings _settings;

        public Hull(in ShipSettings settings) => _settings = settings;

        /// <summary>Height of the deck, z metres aft of the middle.</summary>
        public double DeckHeight(double z)
        {
            double start = _settings.HouseFrontZ - LevelBeforeHouse, bow = -_settings.Length / 2;
            double forward = math.max(0, (start - z) / (start - bow));
            // It rises from the quarterdeck to the foredeck alongside the deckhouse.
            double lower = _settings.HouseAftZ, upper = Deckhouse.Shoulder * _settings.HouseFrontZ;
            double rise = math.clamp((lower - z) / (lower - upper), 0, 1);
            return _settings.Freeboard + _settings.Forecastle * rise * rise * (3 - 2 * rise)
                + _settings.Sheer * forward * forward;
        }

        /// <summary>Half the width of the deck there.</summary>
        public double DeckHalfWidth(double z) => _settings.Beam / 2 * DeckWidth(0.5 - z / _settings.Length);

        /// <param name="triangles">Approximate number; the hull has whole steps along the ship.</param>
        public ShipPart Build(int triangles)
        {
            // Square cells: a side is some seven times as long as its girth.
            int down = math.max(8, (int)math.round(math.sqrt(triangles / 34.0)));
            int along = math.max(8, (int)math.round((triangles - 2.0 * down * Across) / (4 * down + 2 * Across)));
            double3[][] starboard = new double3[along + 1][], port = new double3[along + 1][],
                deck = new double3[along + 1][];
            for (int i = 0; i <= along; i++)
            {
                starboard[i] = new double3[down + 1];
                port[i] = new double3[down + 1];
                for (int j = 0; j <= down; j++)
                {
                    double3 point = Point((double)i / along, (double)j / down);
                    starboard[i][j] = point;
                    port[i][down - j] = new double3(-point.x, point.yz);
                }
                deck[i] = Crossing(starboard[i][down]);
            }
            var transom = new double3[down + 1][];
            for (int j = 0; j <= down; j++)
                transom[j] =
                    System.Array.ConvertAll(Crossing(starboard[0][down - j]), point => new double3(-point.x, point.yz));

            var part = new ShipPart();
            part.AddPatch(starboard);
            part.AddPatch(port);
            part.AddPatch(deck);
            part.AddPatch(transom);
            return part;
        }

        // A straight line from a point on the starboard side to its mirror image.
        static double3[] Crossing(double3 starboard)
        {
            var points = new double3[Across + 1];
            for (int i = 0; i <= Across; i++)
                points[i] = new double3(starboard.x * (Across - 2 * i) / Across, starboard.yz);
            return points;
        }

        /// <param name="along">0 at the stern, 1 at the stem.</param>
        /// <param name="girth">0 at the keel, 1 at the deck.</param>
        double3 Point(double along, double girth)
        {
            // Bow and stern of a frame between circle and square:
            // (2u, 2u^2)/(1 + u^2) is a quarter circle from the keel to the side.
            double quarter = 1 + girth * girth, out2 = 2 * girth / quarter, up2 = 2 * girth * girth / quarter;
            double width = (out2 + math.sqrt(out2)) / 2, height = 1 - (1 - up2 + math.sqrt(1 - up2)) / 2;

            // Towards the stem the frame becomes a V with a slightly round foot, so that no two points coincide on the
            // keel.
            double towardsBow = math.max(0, (along - Widest) / (1 - Widest)), vee = towardsBow * towardsBow;
            width += 0.9 * vee * (height - width);

            double deck = DeckWidth(along), keel = deck * (1 - 0.06 - _settings.Flare * vee);
            double x = _settings.Beam / 2 * width * (keel + (deck - keel) * height * height);

            double z = _settings.Length / 2 - along * (_settings.Length - Overhang(height));
            double deckAtStation = DeckHeight(_settings.Length * (0.5 - along)), bottom = KeelHeight(along);
            return new double3(x, bottom + (deckAtStation - bottom) * height, z);
        }

        // Distance from the tip of the bow to the stem at a height, 0 keel to 1 deck.
        double Overhang(double height)
        {
            double above = DeckHeight(-_settings.Length / 2);
            double down = (1 - height) * (above + _settings.Draught) / above;
            return _settings.Rake * down * (0.8 + 0.2 * down);
        }

        double KeelHeight(double along)
        {
            double aft = math.max(0, (KeelRise - along) / KeelRise), forward = math.max(0, (along - 0.75) / 0.25);
            return -_settings.Draught * (1 - 0.92 * aft * aft - 0.35 * forward * forward * forward);
        }

        // Width of the deck as a fraction of the beam.
        double DeckWidth(double along)
        {
            if (along < Widest)
            {
                double aft = (Widest - along) / Widest;
                return 1 - (1 - _settings.Transom) * aft * aft;
            }
            double forward = (along - Widest) / (1 - Widest);
            return 1 - forward * forward * forward * (0.4 + 0.6 * forward);
        }
    }
}
