using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>What <c>--clutter</c> asks for: off, on as the sea's settings say, or on at a level.</summary>
    public readonly struct ClutterChoice
    {
        const string On = "on", Off = "off";

        readonly bool _isOn;
        readonly ClutterLevel? _level;

        ClutterChoice(bool isOn, ClutterLevel? level) => (_isOn, _level) = (isOn, level);

        /// <summary>Every value.</summary>
        public static IReadOnlyList<string> Names { get; } = Enum.GetValues(typeof(ClutterLevel)).Cast<ClutterLevel>()
            .Select(ClutterModel.NameOf).Prepend(On).Append(Off).ToArray();

        /// <summary>Reads a value.</summary>
        /// <exception cref="FormatException">There is no such value.</exception>
        public static ClutterChoice Read(string text)
        {
            if (text == On || text == Off)
                return new ClutterChoice(text == On, null);
            foreach (ClutterLevel level in Enum.GetValues(typeof(ClutterLevel)))
                if (ClutterModel.NameOf(level) == text)
                    return new ClutterChoice(true, level);
            throw new FormatException("must be one of " + string.Join(", ", Names));
        }

        /// <summary>Settings with this choice.</summary>
        public SeaClutterSettings AppliedTo(SeaClutterSettings settings)
        {
            (settings.IsOn, settings.Level) = (_isOn, _level ?? settings.Level);
            return settings;
        }
    }
}
