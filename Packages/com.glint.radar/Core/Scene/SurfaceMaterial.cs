namespace Glint.Core
{
    /// <summary>What a surface does to a wave. Perfect conductors only, so far: a name to tell them apart.</summary>
    public sealed class SurfaceMaterial
    {
        /// <summary>The material of triangles that are given none.</summary>
        public static readonly SurfaceMaterial PerfectConductor = new SurfaceMaterial("perfect conductor");

        /// <summary>A material.</summary>
        public SurfaceMaterial(string name) => Name = name;

        /// <summary>For messages and results.</summary>
        public string Name { get; }
    }
}
