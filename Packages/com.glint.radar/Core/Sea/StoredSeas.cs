using Unity.Mathematics;
namespace Glint.Core
{
    public static class StoredSeas
    {
        public static readonly SeaRecipe[] All =
        {
            new SeaRecipe("SeaState5", SeaSettings.Default, new double[] { 0, 3, 6, 9, 12, 15, 18, 21, 24, 27 }, new int2(1, 2)),
            new SeaRecipe("SeaState6", SeaSettings.Default, new double[] { 0, 3, 6, 9, 12, 15, 18, 21, 24, 27 }, new int2(1, 2)),
        };
    }
}
