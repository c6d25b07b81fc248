using System.Linq;
using System.Reflection;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>Fields and figures of the inspector of a RadarScreen.</summary>
    public sealed class ScreenFiguresTests
    {
        RadarScreen _screen;

        [SetUp]
        public void Make()
        {
            _screen = new GameObject("Mast").AddComponent<RadarScreen>();
            _screen.Kernel = TestKernels.Screen;
        }

        [TearDown]
        public void Destroy() => Object.DestroyImmediate(_screen.gameObject);

        [Test]
        public void Fields_AreAllOfTheSettings_WithTooltips()
        {
            void AssertAll<T>((string field, string label, string tooltip)[] rows)
            {
                Assert.That(rows.Select(row => row.field), Is.EquivalentTo(
                    typeof(T).GetFields(BindingFlags.Public | BindingFlags.Instance).Select(field => field.Name)));
                Assert.That(rows.Select(row => row.tooltip), Is.All.EndsWith("."));
            }
            AssertAll<ScreenRadar>(ScreenFigures.Radar);
            AssertAll<ScreenReceiver>(ScreenFigures.Receiver);
            AssertAll<ScreenDisplay>(ScreenFigures.Display);
            AssertAll<ScreenDetection>(ScreenFigures.Detection);
        }

        // 25 kW, 29.9 dB, 10 MHz and 5 dB: 21.6 dB over noise for 10 m2 at 4.9 miles.
        [Test]
        public void Rows_HaveTheLevelOfAReflectorAtTheEdge()
        {
            var radar = ScreenRadar.Default;
            (radar.PulseNanoseconds, radar.RangeScale) = (100, 4.9 * ScreenRadar.NauticalMile);
            _screen.Radar = radar;
            var rows = ScreenFigures.Rows(_screen).ToDictionary(row => row.label, row => row.value);
            Assert.That(rows["10 m2 over noise"], Is.EqualTo("21.6 dB"));
            Assert.That(rows["Noise"], Is.EqualTo("-129.0 dBW"));
            Assert.That(rows["Pulse"], Is.EqualTo("15 m"));
            Assert.That(rows["Cell"], Is.EqualTo("8.86 m by 0.088 deg"));
        }

        [Test]
        public void Screen_ThatCannotTurn_SaysWhy_AndHasNoFigures()
        {
            Assert.That(ScreenFigures.Check(_screen), Is.Null);
            _screen.Kernel = null;
            Assert.That(ScreenFigures.Check(_screen).Text, Does.StartWith("RadarScreen of 'Mast' has no kernel"));
            Assert.That(ScreenFigures.Rows(_screen), Is.Empty);
        }
    }
}
