using System;
using System.Collections.Generic;
using System.Globalization;
using System.Reflection;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class ShipSettingsTests
    {
        // Field, its name in messages, minimum and maximum for the default ship.
        static readonly object[][] Ranges =
        {
            new object[] { "Length", "length", 55.0, 140.0 },
            new object[] { "Beam", "beam", 11.0, 20.0 },
            new object[] { "Freeboard", "freeboard", 1.5, 6.0 },
            new object[] { "Forecastle", "forecastle", 0.0, 3.0 },
            new object[] { "Draught", "draught", 2.0, 8.0 },
            new object[] { "Sheer", "sheer", 0.0, 3.0 },
            new object[] { "Rake", "rake", 0.0, 6.0 },
            new object[] { "Flare", "flare", 0.0, 0.8 },
            new object[] { "Transom", "transom", 0.4, 1.0 },
            new object[] { "HouseFront", "house front", 0.28, 0.36 },
            new object[] { "HouseAft", "house aft", 0.2, 0.34 },
            new object[] { "StoreyHeight", "storey height", 2.0, 4.0 },
            new object[] { "Windows", "windows", 1.0, 15.0 },
            new object[] { "WindowDepth", "window depth", 0.02, 0.5 },
            new object[] { "MastHeight", "mast height", 5.0, 20.0 },
            new object[] { "Triangles", "triangles", 15000.0, 600000.0 },
        };

        [Test]
        public void Ranges_AreOfEveryField() =>
            Assert.That(Array.ConvertAll(Ranges, range => range[0]), Is.EquivalentTo(Array.ConvertAll(
                typeof(ShipSettings).GetFields(BindingFlags.Public | BindingFlags.Instance), field => field.Name)));

        [TestCaseSource(nameof(Ranges))]
        public void Validate_AtTheEndsOfARange_Passes(string field, string name, double min, double max)
        {
            With(field, min).Validate();
            With(field, max).Validate();
        }

        [TestCaseSource(nameof(Ranges))]
        public void Validate_BeyondARange_IsRefusedWithFieldValueAndRange(string field,
            string name, double min, double max)
        {
            bool isWhole = typeof(ShipSettings).GetField(field).FieldType == typeof(int);
            var beyond = new List<double> { Math.Floor(min) - 1, Math.Ceiling(max) + 1 };
            if (!isWhole)
                beyond.AddRange(new[] { double.NaN, double.NegativeInfinity, double.PositiveInfinity });
            foreach (double value in beyond)
            {
                string message = Assert.Throws<GlintException>(() => ShipModel.Build(With(field, value)),
                    $"{field} {value}").Message;
                Assert.That(message,
                    Does.StartWith("ship: " + name + " " + value.ToString(CultureInfo.InvariantCulture)));
                Assert.That(message, Does.Match("must be from .+ to .+"));
            }
        }

        // With all settings the ship is a closed surface.
        [TestCaseSource(nameof(Ranges))]
        public void Build_AtTheEndsOfARange_IsClosed(string field, string name, double min, double max)
        {
            foreach (double value in new[] { min, max })
            {
                var settings = With(field, value);
                settings.Triangles = 15000;
                ShipMesh.AssertClosed(ShipModel.Build(settings));
            }
        }

        static ShipSettings With(string name, double value)
        {
            object settings = ShipSettings.Default;
            var field = typeof(ShipSettings).GetField(name);
            field.SetValue(settings, Convert.ChangeType(value, field.FieldType));
            return (ShipSettings)settings;
        }
    }
}
