using System;
using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class ScreenReportTests
    {
        // From a trough of the noise to a ship beside the radar, and a cell without power.
        [Test]
        public void Levels_AreThoseOfTheTurn()
        {
            var radar = ScreenRadar.Default;
            (radar.Spokes, radar.Cells) = (1024, 64);
            var levels = Enumerable.Range(0, radar.Spokes * radar.Cells).Select(i => -45 + i % 200).Select(i => (float)i)
                .ToArray();
            levels[7] = float.NegativeInfinity;
            using (var folder = new TemporaryFolder())
            {
                using (var file = File.Create(folder.PathOf(ResultTable.Screen.CsvName)))
                    ScreenTurn.Of(new ScreenGeometry(radar, "screen"), levels, levels.Select(_ => 0f), null, 0).Write(file);

                var screen = ScreenReport.Of(folder.Path);

                double lowest = (double)screen["lowest_level"], step = (double)screen["level_step"];
                var bytes = Convert.FromBase64String((string)screen["levels"]);
                Assert.That(step, Is.LessThan(1));
                Assert.That(bytes, Has.Length.EqualTo(levels.Length));
                levels[7] = -45;
                for (int i = 0; i < levels.Length; i++)
                    Assert.That(lowest + step * bytes[i], Is.EqualTo(levels[i]).Within(0.501 * step), $"cell {i}");
            }
        }
    }
}
