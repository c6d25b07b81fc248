using System;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Conversion of a turn's video to a picture, for devices that cannot draw into a texture.
    /// Shaders/ScreenPicture.hlsl has the same in float32.
    /// </summary>
    public sealed class ScreenPicture
    {
        /// <summary>Largest number of spokes that a pixel shows, to each side: SCREEN_PIXEL_SPOKES.</summary>
        public const int MaxSpokes = 64;

        readonly ScreenGeometry _geometry;
        readonly ScreenView _view;
        readonly float2[] _video;

        /// <param name="video">
        /// Brightness and trail of each cell, 0 to 1, spoke by spoke: a turn as it was when its spokes were finished.
        /// </param>
        public ScreenPicture(ScreenGeometry geometry, in ScreenView view, float2[] video) =>
            (_geometry, _view, _video) = (geometry, view, video);

        /// <summary>
        /// Pixels of four bytes (red, green, blue, 255), row by row from the bottom, encoded for screens (sRGB).
        /// </summary>
        public byte[] Draw()
        {
            int side = _view.Side;
            var bytes = new byte[4 * side * side];
            for (int y = 0; y < side; y++)
                for (int x = 0; x < side; x++)
                {
                    var colour = ColourOf(new double2(x + 0.5, y + 0.5) - side / 2.0);
                    for (int i = 0; i < 3; i++)
                        bytes[4 * (y * side + x) + i] = (byte)Math.Round(255 * colour[i]);
                    bytes[4 * (y * side + x) + 3] = 255;
                }
            return bytes;
        }

        /// <summary>The colour of a point of the picture.</summary>
        /// <param name="point">Pixels from the middle, x to the right and y upwards.</param>
        public double3 ColourOf(double2 point)
        {
            double radius = math.length(point), half = _view.Side / 2.0;
            if (radius > half)
                return _view.Colours.Outside;
            double2 video = VideoAt(point, radius);
            double3 colour = math.lerp(_view.Colours.Background, _view.Colours.Trail, video.y);
            colour = math.lerp(colour, _view.Colours.Echo, video.x);
            if (_view.RingSpacing > 0)
            {
                double nearest = Math.Max(1, Math.Floor(radius / _view.RingSpacing + 0.5));
                colour = Over(colour, _view.Colours.Rings, Math.Abs(radius - nearest * _view.RingSpacing));
            }
            colour = WithLine(colour, point, _view.HeadingLine, _view.Colours.Heading);
            colour = WithLine(colour, point, _view.BearingLine, _view.Colours.Marker);
            return _view.Marker > 0
                ? Over(colour, _view.Colours.Marker, Math.Abs(radius - _view.Marker)) : colour;
        }

        // The largest video of the cells that a pixel touches.
        double2 VideoAt(double2 point, double radius)
        {
            double turns = Math.Atan2(point.x, point.y) / (2 * Math.PI) + _view.Up;
            double spoke = (turns - Math.Floor(turns)) * _geometry.Radar.Spokes,
                width = _geometry.Radar.Spokes / (2 * Math.PI * Math.Max(radius, 0.5)),
                cells = _geometry.Radar.Cells / (_view.Side / 2.0);
            int first = (int)Math.Max(0, Math.Floor((radius - 0.5) * cells)),
                last = Math.Min(_geometry.Radar.Cells - 1,
                    Math.Max(first, (int)Math.Ceiling((radius + 0.5) * cells) - 1));
            first = Math.Min(first, last);
            if (width < 1)
            {
                int below = (int)Math.Floor(spoke);
                return math.lerp(Largest(below, first, last), Largest(below + 1, first, last), spoke - below);
            }
            double reach = Math.Min(width / 2, MaxSpokes);
            double2 largest = 0;
            for (int at = (int)Math.Floor(spoke - reach + 0.5); at <= (int)Math.Floor(spoke + reach + 0.5); at++)
                largest = math.max(largest, Largest(at, first, last));
            return largest;
        }

        double2 Largest(int spoke, int first, int last)
        {
            int at = _geometry.InTurn(spoke), age = _geometry.InTurn(_view.Front - at);
            float2 largest = 0;
            for (int cell = first; cell <= last; cell++)
                largest = math.max(largest, _video[at * _geometry.Radar.Cells + cell]);
            return largest * math.exp(-_view.FadeASpoke * age);
        }

        static double3 WithLine(double3 colour, double2 point, double4 line, double3 of) => line.z > 0
            && point.x * line.x + point.y * line.y > 0
                ? Over(colour, of, Math.Abs(point.x * line.y - point.y * line.x)) : colour;

        static double3 Over(double3 colour, double3 of, double distance) =>
            math.lerp(colour, of, Math.Max(0, 1 - distance));
    }

    /// <summary>What a picture shows, in pixels and turns.</summary>
    public struct ScreenView
    {
        /// <summary>Pixels along a side.</summary>
        public int Side;

        /// <summary>True bearing at the top, turns.</summary>
        public double Up;

        /// <summary>The spoke that was finished last.</summary>
        public int Front;

        /// <summary>Exponents of the fading of video and trails a spoke.</summary>
        public double2 FadeASpoke;

        /// <summary>Pixels between range rings; 0: none.</summary>
        public double RingSpacing;

        /// <summary>Direction of the heading line in the picture; z: 1 if it is drawn.</summary>
        public double4 HeadingLine;

        /// <summary>The same of the electronic bearing line.</summary>
        public double4 BearingLine;

        /// <summary>Radius of the variable range marker in pixels; 0: none.</summary>
        public double Marker;

        /// <summary>The colours.</summary>
        public ScreenColours Colours;

        /// <summary>Colours the pixel of a place.</summary>
        /// <param name="pixels">Of <see cref="ScreenPicture.Draw"/>.</param>
        /// <param name="turns">True bearing.</param>
        /// <param name="range">As a part of the range scale, 0 to 1.</param>
        public void Mark(byte[] pixels, double turns, double range)
        {
            double angle = 2 * Math.PI * (turns - Up), half = Side / 2.0;
            int x = Math.Min(Side - 1, (int)(half + half * range * Math.Sin(angle))),
                y = Math.Min(Side - 1, (int)(half + half * range * Math.Cos(angle)));
            for (int i = 0; i < 3; i++)
                pixels[4 * (y * Side + x) + i] = (byte)Math.Round(255 * Colours.Marker[i]);
        }

        /// <summary>The view of a display.</summary>
        /// <param name="headingTurns">Of the own ship, from north.</param>
        /// <param name="front">The spoke that was finished last.</param>
        public static ScreenView Of(ScreenGeometry geometry, in ScreenDisplay display, in ScreenReceiver receiver,
            in ScreenColours colours, double headingTurns, long front)
        {
            int spokes = geometry.Radar.Spokes;
            double half = display.Side / 2.0, up = display.Orientation == PictureOrientation.HeadUp ? headingTurns : 0;
            double4 Line(bool isDrawn, double turns) => new double4(Math.Sin(2 * Math.PI * (turns - up)),
                Math.Cos(2 * Math.PI * (turns - up)), isDrawn ? 1 : 0, 0);
            return new ScreenView
            {
                Side = display.Side, Up = up - Math.Floor(up), Front = (int)(front & (spokes - 1)),
                FadeASpoke = receiver.FadeATurn / spokes,
                RingSpacing = display.RangeRings > 0 ? half / display.RangeRings : 0,
                HeadingLine = Line(display.HasHeadingLine, headingTurns),
                BearingLine = Line(display.HasBearingLine, display.BearingLine / 360),
                Marker = display.RangeMarker / geometry.Radar.RangeScale * half, Colours = colours
            };
        }
    }

    /// <summary>Colours of a picture, red, green and blue from 0 to 1, encoded for screens (sRGB).</summary>
    public struct ScreenColours
    {
        /// <summary>Outside of the range scale, and inside of it.</summary>
        public double3 Outside, Background;

        /// <summary>Of full video, and of full trails.</summary>
        public double3 Echo, Trail;

        /// <summary>Of rings, of the heading line, and of bearing line and range marker.</summary>
        public double3 Rings, Heading, Marker;
    }
}
