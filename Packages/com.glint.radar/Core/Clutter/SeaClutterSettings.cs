using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>Settings of a sea's diffuse echo.</summary>
    [Serializable]
    public struct SeaClutterSettings
    {
        static readonly Interval s_winds = Interval.Closed(0, Elfouhaily.MaxWind),
            s_seeds = Interval.Closed(0, int.MaxValue);

        /// <summary>The numbers, in the order of the declaration.</summary>
        public static readonly IReadOnlyList<Measure> Measures = new MeasureList<SeaClutterSettings>
        {
            { nameof(Wind), it => it.Wind, "Clutter Wind", "m/s", s_winds,
                "Wind of the waves that the mesh leaves out, 3 to 20. 0: that of the sea; of a sea whose height is "
                    + "given, the wind that raises it." },
            { nameof(WaterTemperature), it => it.WaterTemperature, "Water Temperature", "C", SeaWater.Temperatures,
                "Temperature of the water." },
            { nameof(Salinity), it => it.Salinity, "Salinity", "psu", SeaWater.Salinities,
                "Salt of the water. The ocean has 35." },
            { nameof(WhitecapCoefficient), it => it.WhitecapCoefficient, "Whitecap Coefficient", "",
                WhitecapLaw.Coefficients,
                "Fraction of the sea that breaks, over the 3.41th power of the wind. Published laws differ by a "
                    + "factor of several. 0: none." },
            { nameof(Gustiness), it => it.Gustiness, "Gustiness", "", Gusts.Gustinesses,
                "Standard deviation of the wind over its friction velocity. 2.2 to 2.4 in neutral air, up to 4 over a "
                    + "sea much warmer than the air. 0: no gusts." },
            { nameof(Seed), it => it.Seed, "Seed", "", s_seeds,
                "Seed of speckle and gusts. The same number gives the same ones." }
        };

        /// <summary>Whether the sea has a diffuse echo, and the reflection of sea water.</summary>
        public bool IsOn;

        /// <summary>Where the mean of the diffuse echo comes from.</summary>
        public ClutterLevel Level;

        /// <summary>
        /// Wind of the short waves in m/s, 3 to 20; 0: <see cref="ShortWaves.DefaultWind"/>.
        /// </summary>
        public double Wind;

        /// <summary>Degrees Celsius.</summary>
        public double WaterTemperature;

        /// <summary>Practical salinity units.</summary>
        public double Salinity;

        /// <summary>Of a <see cref="WhitecapLaw"/>; 0: no wave breaks.</summary>
        public double WhitecapCoefficient;

        /// <summary>Standard deviation of the wind over its friction velocity; 0: no gusts.</summary>
        public double Gustiness;

        /// <summary>Seed of speckle and gusts.</summary>
        public int Seed;

        /// <summary>
        /// A sea with clutter: water of 20 C and 35 psu, the default whitecap law, and the gusts of neutral air.
        /// </summary>
        public static SeaClutterSettings On => new SeaClutterSettings
        {
            IsOn = true, WaterTemperature = 20, Salinity = 35, WhitecapCoefficient = WhitecapLaw.DefaultCoefficient,
            Gustiness = Gusts.DefaultGustiness, Seed = 1,
        };

        /// <summary>The same values, with clutter off.</summary>
        public static SeaClutterSettings Off
        {
            get
            {
                var settings = On;
                settings.IsOn = false;
                return settings;
            }
        }

        /// <summary>Refuses values out of range.</summary>
        /// <param name="subject">Whose settings they are, for messages.</param>
        /// <exception cref="GlintException">A value is out of its range.</exception>
        public void Validate(string subject = "sea")
        {
            foreach (var measure in Measures)
                Require.Within(subject, measure, this);
        }
    }
}
