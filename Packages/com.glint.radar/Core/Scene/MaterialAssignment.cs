using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Core
{
    /// <summary>The material of the surfaces of a mesh file, as an option gives it: NAME=MATERIAL.</summary>
    public readonly struct MaterialAssignment
    {
        /// <summary><see cref="Surface"/> for every surface of the file.</summary>
        public const string AnySurface = "*";

        const string Metal = "metal", Open = "open";

        const string Forms = "NAME=metal; NAME=metal,MEDIUM,t; NAME=open,MEDIUM; or NAME=PUBLISHED, the name of a "
            + "published material; MEDIUM is e',e'',mu',mu'' or PUBLISHED, t its thickness in metres, and NAME a "
            + "material of the file or * for all: such as *=metal,4,0.4,1,0,0.002";

        MaterialAssignment(string surface, SurfaceMaterial material) => (Surface, Material) = (surface, material);

        /// <summary>Material name in the file, or <see cref="AnySurface"/>.</summary>
        public string Surface { get; }

        /// <summary>
        /// Its material, which has the name of the surface, or that of the text after = if for any surface.
        /// </summary>
        public SurfaceMaterial Material { get; }

        /// <summary>
        /// Reads NAME=metal or NAME=open, followed by layers MEDIUM,t from the outermost one, and after open by the
        /// MEDIUM of the half-space; or NAME=PUBLISHED.
        /// </summary>
        /// <exception cref="FormatException">Malformed; the message says what the text must be.</exception>
        public static MaterialAssignment Read(string text)
        {
            // A name of the file may hold =, its material does not.
            int split = text.LastIndexOf('=');
            if (split < 1 || split == text.Length - 1)
                throw new FormatException("must be " + Forms);
            string surface = text.Substring(0, split), definition = text.Substring(split + 1);
            string name = surface == AnySurface ? definition : surface;
            try
            {
                return new MaterialAssignment(surface, ReadMaterial(name, definition.Split(',')));
            }
            catch (GlintException refusal)
            {
                throw new FormatException(refusal.Message);
            }
        }

        /// <summary>
        /// A scene whose surfaces have the materials assigned to them: by their name, the others by
        /// <see cref="AnySurface"/> if that is given.
        /// </summary>
        /// <exception cref="GlintException">
        /// A surface is given twice (a <see cref="UsageException"/>) or is not in the scene; the message names those
        /// that are.
        /// </exception>
        public static RadarScene Apply(RadarScene scene, IReadOnlyList<MaterialAssignment> assignments)
        {
            var bySurface = new Dictionary<string, SurfaceMaterial>();
            var names = scene.Surfaces.Skip(1).Select(surface => surface.Name).Distinct().ToArray();
            foreach (var assignment in assignments)
            {
                if (assignment.Surface != AnySurface && !names.Contains(assignment.Surface))
                    throw new GlintException($"there is no surface {Values.Shown(assignment.Surface)} to give a "
                        + (names.Length == 0
                            ? $"material to: the triangles name none, give {AnySurface} for all"
                            : $"material to: the surfaces are {string.Join(", ", names.Select(Values.Shown))}, "
                                + $"and {AnySurface} for all others"));
                if (!bySurface.TryAdd(assignment.Surface, assignment.Material))
                    throw new UsageException($"the surface {Values.Shown(assignment.Surface)} is given two materials: "
                        + "give one");
            }
            // The first surface is the perfect conductor, of triangles that name none.
            var surfaces = new List<SurfaceMaterial> { SurfaceMaterial.PerfectConductor };
            var places = scene.Surfaces.Select((surface, i) =>
            {
                if ((i == 0 || !bySurface.TryGetValue(surface.Name, out var material))
                    && !bySurface.TryGetValue(AnySurface, out material))
                    material = surface;
                if (!surfaces.Contains(material))
                    surfaces.Add(material);
                return surfaces.IndexOf(material);
            }).ToArray();
            return new RadarScene(Array.ConvertAll(scene.Instances, instance =>
            {
                instance.Ranges = Array.ConvertAll(instance.Ranges,
                    range => new MeshRange(range.FirstTriangle, range.Object, places[range.Surface]));
                return instance;
            }))
            { Origin = scene.Origin, Surfaces = surfaces, Seas = scene.Seas };
        }

        static SurfaceMaterial ReadMaterial(string name, string[] parts)
        {
            if (parts[0] != Metal && parts[0] != Open)
                return parts.Length == 1
                    ? PublishedMaterial.Find(parts[0]).ToSurface(name)
                    : throw new FormatException($"begins with {Values.Shown(parts[0])}: must be {Forms}");
            var remaining = new Queue<string>(parts.Skip(1));
            var layers = new List<MaterialLayer>();
            while (remaining.Count > 0)
            {
                var medium = ReadMedium(remaining);
                if (remaining.Count == 0 && parts[0] == Open)
                    return new SurfaceMaterial(name, layers, medium);
                layers.Add(new MaterialLayer(medium, ReadNumber(remaining, "the thickness t in metres")));
            }
            return parts[0] == Metal
                ? new SurfaceMaterial(name, layers)
                : throw new FormatException($"the medium of the half-space is missing: must be {Forms}");
        }

        static Medium ReadMedium(Queue<string> remaining) => Values.TryReal(remaining.Peek(), out _)
            ? Medium.Constant(ReadNumber(remaining, "e'"), ReadNumber(remaining, "e''"), ReadNumber(remaining, "mu'"),
                ReadNumber(remaining, "mu''"))
            : PublishedMaterial.Find(remaining.Dequeue()).Medium;

        static double ReadNumber(Queue<string> remaining, string what)
        {
            if (remaining.Count == 0)
                throw new FormatException($"{what} is missing: must be {Forms}");
            string text = remaining.Dequeue();
            return Values.TryReal(text, out double value)
                ? value
                : throw new FormatException($"{what} is {Values.Shown(text)}, not a number: must be {Forms}");
        }
    }
}
