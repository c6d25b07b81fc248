using System;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The grid of ray tubes on the wavefront: square cells, turned against edges that are level or upright, that cover
    /// the box around the scene.
    /// </summary>
    public sealed class TubeGrid
    {
        /// <summary>Turn against the radar's axes, degrees: rows along an edge would take it in or out as a whole.</summary>
        public const double TurnDegrees = 27.3;

        /// <summary>
        /// Wavelengths that a piece of an edge is long: what hides less of it is found at its ends alone. A mast of a wavelength
        /// may hide the middle of a longer piece.
        /// </summary>
        public const double EdgeWavelengths = 0.5;

        // Shift against the centre of the box, cells: on a grid with the symmetry of its target, errors of opposite borders
        // are the same instead of independent. A grid has half a cell to spare on each side.
        const double ShiftX = 0.31, ShiftY = -0.19;

        // Side of a cell of a camera's picture, most of which returns nothing: cells are divided where corners of
        // patches are, and where paths differ.
        const double PictureWavelengths = 4;

        // Side of a cell of a large target, most of whose echo comes from large parts: the outlines of patches show what
        // rays through corners miss. With four wavelengths the errors of a ship exceed those said. Cells across a target,
        // and across a large one.
        const double LargeWavelengths = 3, CellsAcross = 16, LargeCellsAcross = 64;

        // Maximum side of a cell at a finite range, as a fraction of sqrt(wavelength x range).
        const double MaxNearSide = 0.22;

        readonly double _range;

        /// <summary>A grid of cells of a side, over a box, in the scene's frame, metres.</summary>
        public TubeGrid(CrossSectionPose pose, double side, double3 boxMin, double3 boxMax)
            : this(pose, side, boxMin, boxMax, pose.Footprint, boxMin, boxMax)
        {
        }

        /// <summary>
        /// A grid over the box around a part of the scene, whatever the picture: from before the whole scene.
        /// </summary>
        public TubeGrid(CrossSectionPose pose, double side, double3 boxMin, double3 boxMax, double3 partMin,
            double3 partMax) : this(pose, side, boxMin, boxMax, null, partMin, partMax)
        {
        }

        TubeGrid(CrossSectionPose pose, double side, double3 boxMin, double3 boxMax, RadarFootprint footprint,
            double3 partMin, double3 partMax)
        {
            Side = side;
            _range = pose.Range;
            View = footprint == null ? ViewOf(pose, partMin, partMax, DepthOf(pose, boxMin, boxMax))
                : ViewOf(footprint, pose, boxMin, boxMax);
            Settings = new RadarSettings
            {
                FrequencyHz = pose.Frequencies[pose.Frequencies.Length - 1], RaysAcross = Cells.x, RaysDown = Cells.y,
                MaxBounces = pose.MaxBounces
            };
            Rays = new RayGrid(Settings, View, boxMin, boxMax);
        }

        // Of the box before the phase centre, towards the radar.
        static double DepthOf(CrossSectionPose pose, double3 boxMin, double3 boxMax)
        {
            double depth = 0;
            for (int corner = 0; corner < 8; corner++)
                depth = Math.Max(depth,
                    math.dot(Box.CornerOf(boxMin, boxMax, corner) - pose.PhaseCentre, pose.Radar.ToRadar));
            return depth;
        }

        // Sets the cells too.
        RadarView ViewOf(CrossSectionPose pose, double3 boxMin, double3 boxMax, double depth)
        {
            double turn = math.radians(TurnDegrees), cos = Math.Cos(turn), sin = Math.Sin(turn);
            double3 right = cos * pose.Radar.Right + sin * pose.Radar.Up;
            double3 up = cos * pose.Radar.Up - sin * pose.Radar.Right;
            var (lower, upper) = Seen(pose, right, up, boxMin, boxMax);
            double2 centre = (lower + upper) / 2;
            if (!pose.IsFar)
            {
                upper = math.max(math.abs(lower), math.abs(upper));
                (lower, centre) = (-upper, 0);
            }
            else
                centre += Side * new double2(ShiftX, ShiftY);
            Cells = (int2)math.max(1, math.ceil((upper - lower) / Side + 1));
            double distance = pose.IsFar ? depth + Side : pose.Range;
            double height = Cells.y * Side;
            return new RadarView
            {
                Position = pose.PhaseCentre + distance * pose.Radar.ToRadar + centre.x * right + centre.y * up,
                Right = right, Up = up, Forward = -pose.Radar.ToRadar,
                ApertureHeight = pose.IsFar ? height : 0,
                VerticalFovDegrees = FovOf(height, pose)
            };
        }

        // Of a box across the direction to the radar, at the range of the phase centre, metres from it.
        static (double2, double2) Seen(CrossSectionPose pose, double3 right, double3 up, double3 boxMin, double3 boxMax)
        {
            double2 lower = double.PositiveInfinity, upper = double.NegativeInfinity;
            for (int corner = 0; corner < 8; corner++)
            {
                double3 at = Box.CornerOf(boxMin, boxMax, corner) - pose.PhaseCentre;
                double towards = math.dot(at, pose.Radar.ToRadar);
                double scale = pose.IsFar ? 1 : pose.Range / Math.Max(pose.Range - towards, 1e-3 * pose.Range);
                double2 place = scale * new double2(math.dot(at, right), math.dot(at, up));
                lower = math.min(lower, place);
                upper = math.max(upper, place);
            }
            return (lower, upper);
        }

        // The camera's picture, in cells that it may exceed by one, without those on both sides of the scene.
        RadarView ViewOf(RadarFootprint footprint, CrossSectionPose pose, double3 boxMin, double3 boxMax)
        {
            var view = footprint.View;
            double2 size = (pose.IsFar ? 2 : 2 * pose.Range) * footprint.HalfSize, cells = math.max(1, math.ceil(size / Side));
            var (lower, upper) = Seen(pose, view.Right, view.Up, boxMin, boxMax);
            double2 axis = new double2(math.dot(view.Position - pose.PhaseCentre, view.Right),
                math.dot(view.Position - pose.PhaseCentre, view.Up));
            double2 spare = math.floor(cells / 2 - math.max(math.abs(lower - axis), math.abs(upper - axis)) / Side - 1);
            Cells = (int2)(cells - 2 * math.max(0, spare));
            (view.ApertureHeight, view.VerticalFovDegrees) =
                (pose.IsFar ? Cells.y * Side : 0, FovOf(Cells.y * Side, pose));
            return view;
        }

        static double FovOf(double height, CrossSectionPose pose) =>
            pose.IsFar ? 60 : math.degrees(2 * Math.Atan(height / (2 * pose.Range)));

        /// <summary>Side of a cell, metres; at a finite range, at that range.</summary>
        public double Side { get; }

        /// <summary>Cells across and up.</summary>
        public int2 Cells { get; private set; }

        /// <summary>Number of cells.</summary>
        public long Count => (long)Cells.x * Cells.y;

        /// <summary>The grid as a picture whose pixels are its cells.</summary>
        public RadarSettings Settings { get; }

        /// <summary>The view of that picture.</summary>
        public RadarView View { get; }

        /// <summary>Its rays.</summary>
        public RayGrid Rays { get; }

        /// <summary>
        /// The base cell of a place relative to the scene's centre: x and y, each the product of place and vector plus
        /// its constant, over those of the depth.
        /// </summary>
        public (double3 Vector, double Constant)[] ToCell()
        {
            double3 from = View.Position - Rays.SceneCentre;
            double3 depth = View.IsParallel ? 0 : View.Forward / _range;
            double depthFrom = View.IsParallel ? 1 : -math.dot(depth, from);
            (double3, double) Along(double3 axis, double middle)
            {
                double3 vector = axis / Side;
                return (vector + middle * depth, middle * depthFrom - math.dot(vector, from));
            }
            return new[] { Along(View.Right, Cells.x / 2.0), Along(View.Up, Cells.y / 2.0), (depth, depthFrom) };
        }

        /// <summary>
        /// Side of a cell: a wavelength, of a target of more than 64 up to three, and in a camera's picture four; less for a
        /// target of few wavelengths, or where the wave is curved.
        /// </summary>
        public static double SideFor(CrossSectionPose pose, double3 boxMin, double3 boxMax)
        {
            double wavelength = Signal.Wavelength(pose.Frequencies[pose.Frequencies.Length - 1]);
            double size = math.length(boxMax - boxMin);
            double side = pose.Footprint != null ? Math.Min(PictureWavelengths * wavelength, size / CellsAcross)
                : math.clamp(size / LargeCellsAcross, Math.Min(wavelength, size / CellsAcross),
                    LargeWavelengths * wavelength);
            return pose.IsFar ? side : Math.Min(side, MaxNearSide * Math.Sqrt(wavelength * pose.Range));
        }

        /// <summary>
        /// Maximum length of a piece of an edge: <see cref="EdgeWavelengths"/>, less where the wave is curved.
        /// </summary>
        public static double EdgePieceFor(CrossSectionPose pose)
        {
            double wavelength = Signal.Wavelength(pose.Frequencies[pose.Frequencies.Length - 1]);
            double length = EdgeWavelengths * wavelength;
            return pose.IsFar ? length : Math.Min(length, MaxNearSide * Math.Sqrt(wavelength * pose.Range));
        }

        /// <summary>
        /// What the phases of paths have beside the way from the origin of the kernels' coordinates to the radar less
        /// that from the place, metres.
        /// </summary>
        public double RadarPhaseOf(CrossSectionPose pose)
        {
            if (!pose.IsFar)
                return Rays.OriginDepth - math.distance(View.Position, Rays.SceneCentre);
            return -math.dot(pose.Radar.ToRadar, Rays.Origin);
        }

        /// <summary>
        /// What the phases of the kernels lack, metres: distance to a receiver less path length, of the origin of the
        /// kernels' coordinates.
        /// </summary>
        public double PhaseOf(CrossSectionPose pose, RadarAspect receiver)
        {
            double3 centre = Rays.SceneCentre - pose.PhaseCentre;
            if (!pose.IsFar)
                return 2 * pose.Range - math.length(pose.Range * receiver.ToRadar - centre) - Rays.OriginDepth;
            return math.dot(receiver.ToRadar, centre) + math.dot(pose.Radar.ToRadar, Rays.Origin + centre);
        }
    }
}
