using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The pattern of a radar's antenna and where the middle of its beam points. The gain of a target is that towards
    /// the phase centre.
    /// </summary>
    public sealed class EchoAntenna
    {
        /// <summary>Largest part of the narrower beam width that a target may take.</summary>
        public const double MaxPartOfBeam = 0.1;

        /// <summary>First line of a table: angles from the middle of the beam, levels over its gain.</summary>
        public const string TableHeader = "angle_deg,azimuth_db,elevation_db";

        const string PatternName = "antenna", AzimuthName = "antenna_azimuth_width",
            ElevationName = "antenna_elevation_width", FromName = "antenna_cosecant_from",
            ToName = "antenna_cosecant_to", TableName = "antenna_table", SquintName = "antenna_squint",
            TiltName = "antenna_tilt", Table = "table", AtPhaseCentre = "at the phase centre";

        /// <summary>
        /// Names of analytic patterns: <see cref="AntennaPattern.Gaussian"/>, <see cref="AntennaPattern.Sinc"/>, and
        /// <see cref="AntennaPattern.CosecantSquared"/> in elevation with a Gaussian one in azimuth.
        /// </summary>
        public static readonly IReadOnlyList<string> Names = new[] { "gaussian", "sinc", Cosecant };

        /// <summary>The name of the pattern that needs the angles of a cosecant.</summary>
        public const string Cosecant = "csc2";

        static readonly Interval s_levels = Interval.Closed(-300, 0);

        readonly string _name, _table;
        readonly double2? _cosecant;
        readonly AntennaPattern _azimuth, _elevation;

        /// <summary>An analytic pattern.</summary>
        /// <param name="name">One of <see cref="Names"/>.</param>
        /// <param name="widths">Half-power widths in azimuth and in elevation, degrees.</param>
        /// <param name="cosecant">Where the cosecant begins and ends, degrees; only with its name.</param>
        /// <exception cref="GlintException">A width or an angle is out of its range.</exception>
        public EchoAntenna(string name, double2 widths, double2? cosecant)
        {
            (_name, _cosecant) = (name, cosecant);
            bool isSinc = name == Names[1];
            _azimuth = isSinc ? AntennaPattern.Sinc(widths.x) : AntennaPattern.Gaussian(widths.x);
            _elevation = cosecant is double2 angles
                ? AntennaPattern.CosecantSquared(widths.y, angles.x, angles.y)
                : isSinc ? AntennaPattern.Sinc(widths.y) : AntennaPattern.Gaussian(widths.y);
        }

        /// <summary>A pattern of a table.</summary>
        /// <param name="table"><see cref="TableHeader"/>, then rows of three numbers; lines end with LF or ;.</param>
        /// <exception cref="FormatException">It is no such table.</exception>
        /// <exception cref="GlintException">The angles have no order.</exception>
        public EchoAntenna(string table)
        {
            string[] lines = table.Split('\n', ';').Select(line => line.Trim()).Where(line => line.Length > 0).ToArray();
            if (lines.Length == 0 || lines[0] != TableHeader)
                throw new FormatException($"an antenna's table must begin with the line {TableHeader}");
            double3[] rows = lines.Skip(1).Select(RowOf).ToArray();
            double[] angles = rows.Select(row => row.x).ToArray();
            (_name, _table) = (Table, string.Join(";", lines));
            _azimuth = AntennaPattern.Table(angles, rows.Select(row => FieldOf(row.y)).ToArray());
            _elevation = AntennaPattern.Table(angles, rows.Select(row => FieldOf(row.z)).ToArray());
        }

        /// <summary>Azimuth of the beam's middle from the direction to the phase centre, degrees, to the right.</summary>
        public double Squint { get; set; }

        /// <summary>Elevation of the beam's middle over the horizontal, degrees; null: that of the phase centre.</summary>
        public double? Tilt { get; set; }

        /// <summary>The cut in azimuth.</summary>
        public AntennaPattern Azimuth => _azimuth;

        /// <summary>The cut in elevation.</summary>
        public AntennaPattern Elevation => _elevation;

        /// <summary>The narrower one of its half-power widths, degrees.</summary>
        public double Width => Math.Min(_azimuth.Width, _elevation.Width);

        /// <summary>Usual gain of an antenna of its widths, decibels.</summary>
        public double UsualGainDb => Antenna.UsualGainDb(_azimuth.Width, _elevation.Width);

        /// <summary>The field towards the phase centre, one way: the square of its magnitude is the gain.</summary>
        /// <param name="gainDb">In the middle of the beam.</param>
        /// <param name="elevation">Of the antenna as seen from the phase centre, degrees over the horizontal.</param>
        public Complex Field(double gainDb, double elevation) => new Antenna(gainDb, _azimuth, _elevation)
            .Field(math.radians(-Squint), Tilt is double tilt ? math.radians(-elevation - tilt) : 0);

        internal void AddTo(List<RunSetting> settings)
        {
            settings.Add(new RunSetting(PatternName, _name));
            settings.Add(new RunSetting(AzimuthName, _azimuth.Width, "deg"));
            settings.Add(new RunSetting(ElevationName, _elevation.Width, "deg"));
            if (_cosecant is double2 angles)
            {
                settings.Add(new RunSetting(FromName, angles.x, "deg"));
                settings.Add(new RunSetting(ToName, angles.y, "deg"));
            }
            if (_table != null)
                settings.Add(new RunSetting(TableName, _table));
            settings.Add(new RunSetting(SquintName, Squint, "deg"));
            settings.Add(Tilt is double tilt ? new RunSetting(TiltName, tilt, "deg")
                : new RunSetting(TiltName, AtPhaseCentre));
        }

        internal static EchoAntenna Of(RunInfo info)
        {
            if (!EchoSettings.Has(info, PatternName))
                return null;
            double Number(string name) => EchoSettings.Find(info, name).Number;
            var antenna = EchoSettings.Has(info, TableName)
                ? new EchoAntenna(EchoSettings.Find(info, TableName).Text)
                : new EchoAntenna(EchoSettings.Find(info, PatternName).Text,
                    new double2(Number(AzimuthName), Number(ElevationName)), EchoSettings.Has(info, FromName)
                        ? new double2(Number(FromName), Number(ToName))
                        : (double2?)null);
            antenna.Squint = Number(SquintName);
            antenna.Tilt = EchoSettings.Find(info, TiltName).Text == AtPhaseCentre ? (double?)null : Number(TiltName);
            return antenna;
        }

        static double3 RowOf(string line)
        {
            var cells = line.Split(',');
            return cells.Length == 3 && Values.TryReal(cells[0], out double angle)
                && Values.TryReal(cells[1], out double azimuth) && Values.TryReal(cells[2], out double elevation)
                && s_levels.Contains(azimuth) && s_levels.Contains(elevation)
                    ? new double3(angle, azimuth, elevation)
                    : throw new FormatException($"the row {Values.Shown(line)} of the antenna's table must be three "
                        + $"numbers, an angle in degrees and two levels {s_levels} dB");
        }

        static Complex FieldOf(double level) => Math.Sqrt(PowerLevel.FromDecibels(level));
    }
}
