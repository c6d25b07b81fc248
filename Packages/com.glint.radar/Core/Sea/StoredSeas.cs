using Unity.Mathematics;

namespace Glint.Core
{
    public static class StoredSeas
    {
        static readonly double[] s_times = { 0, 3, 6, 9, 12, 15, 18, 21, 24, 27 };

        public static readonly SeaRecipe[] All = { Recipe("SeaState5", 2.5), Recipe("SeaState6", 6) };

        static SeaRecipe Recipe(string name, double height)
        {
            var settings = SeaSettings.Default;
            (settings.SignificantWaveHeight, settings.WindSpeed, settings.Choppiness, settings.Cells, settings.Seed) = (height, 9, 1, 94, 4);
            return new SeaRecipe(name, settings, s_times, new int2(1, 2));
        }
    }
}
