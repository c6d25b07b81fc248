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
        public const int MaxSpokes = 512;

        /// <summary>
        /// Half a pixel: TRAIL_REACH. It is smaller, so that rounding decides nothing where edges of pixels meet.
        /// </summary>
        public const double TrailReach = 0.49;

        readonly ScreenGeometry _geometry;
        readonly ScreenView _view;
        readonly float2[] _video;
        readonly float[] _trails;

        /// <param name="video">
        /// Brightness of each cell, 0 to 1, spoke by spoke, with persistence and without: a turn as it was when its
        /// spokes were finished.
        /// </param>
        /// <param name="trails">0 to 1, row by row from the south: <see cref="TrailMap"/>.</param>
        public ScreenPicture(ScreenGeometry geometry, in ScreenView view, float2[] video, float[] trails) =>
            (_geometry, _view, _video, _trails) = (geometry, view, video, trails);

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
            double3 colour = math.lerp(_view.Colours.Background, _view.Colours.Trail, TrailAt(point));
            colour = math.lerp(colour, _view.Colours.Echo, VideoAt(point, radius));
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
        double VideoAt(double2 point, double radius)
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
            double largest = 0;
            for (int at = (int)Math.Floor(spoke - reach + 0.5); at <= (int)Math.Floor(spoke + reach + 0.5); at++)
                largest = Math.Max(largest, Largest(at, first, last));
            return largest;
        }

        double Largest(int spoke, int first, int last)
        {
            int at = _geometry.InTurn(spoke), age = _geometry.InTurn(_view.Front - at);
            double largest = 0;
            for (int cell = first; cell <= last; cell++)
                largest = Math.Max(largest, _video[at * _geometry.Radar.Cells + cell].x);
            return largest * Math.Exp(-_view.FadeASpoke * age);
        }

        // The largest trail of the map's pixels that a pixel touches.
        double TrailAt(double2 point)
        {
            double2 up = _view.TrailUp,
                place = _view.TrailMiddle + point.x * new double2(up.y, -up.x) + point.y * up;
            double reach = TrailReach * math.length(up), largest = 0;
            double2 first = math.floor(place - reach), last = math.floor(place + reach);
            for (int y = (int)first.y; y <= (int)last.y; y++)
                for (int x = (int)first.x; x <= (int)last.x; x++)
                    largest = Math.Max(largest,
                        _trails[(y & (TrailMap.Side - 1)) * TrailMap.Side + (x & (TrailMap.Side - 1))]);
            return largest;
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

        /// <summary>Exponent of the fading of video a spoke.</summary>
        public double FadeASpoke;

        /// <summary>Pixel of the antenna in the map of trails.</summary>
        public double2 TrailMiddle;

        /// <summary>The way of one pixel up in the map of trails, to the east and north.</summary>
        public double2 TrailUp;

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
        /// <param name="trailMiddle">Pixel of the antenna in the map of trails.</param>
        public static ScreenView Of(ScreenGeometry geometry, in ScreenDisplay display, in ScreenReceiver receiver,
            ScreenColours colours, double headingTurns, long front, double2 trailMiddle)
        {
            // The map keeps what it had when trails were turned off.
            if (receiver.TrailTurns == 0)
                colours.Trail = colours.Background;
            int spokes = geometry.Radar.Spokes;
            double half = display.Side / 2.0, up = display.Orientation == PictureOrientation.HeadUp ? headingTurns : 0;
            double4 Line(bool isDrawn, double turns) => new double4(Math.Sin(2 * Math.PI * (turns - up)),
                Math.Cos(2 * Math.PI * (turns - up)), isDrawn ? 1 : 0, 0);
            return new ScreenView
            {
                Side = display.Side, Up = up - Math.Floor(up), Front = geometry.InTurn(front),
                FadeASpoke = receiver.FadeATurn.x / spokes, TrailMiddle = trailMiddle,
                TrailUp = TrailMap.Radius / half
                    * new double2(Math.Sin(2 * Math.PI * up), Math.Cos(2 * Math.PI * up)),
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
