using System;
using System.Globalization;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>
    /// Tables of Documentation~/clutter.md. A test computes each row again, and compares it with the printed one.
    /// </summary>
    static class ClutterPage
    {
        // Printed with one digit after the point.
        const double Rounding = 0.051;

        /// <summary>Asserts that the table below a heading has these rows and no others.</summary>
        /// <param name="rows">A label, and numbers.</param>
        public static void AssertTable(string heading, (string label, double[] numbers)[] rows)
        {
            string computed = string.Join("\n", rows.Select(row => $"| {row.label} | "
                + string.Join(" | ", row.numbers.Select(Text)) + " |"));
            TestContext.WriteLine(computed);
            var printed = Table(heading);
            Assert.That(printed.Select(cells => cells[0]), Is.EqualTo(rows.Select(row => row.label)), computed);
            for (int i = 0; i < rows.Length; i++)
            {
                var numbers = printed[i].Skip(1).Select(cell => double.Parse(cell, CultureInfo.InvariantCulture));
                Assert.That(numbers, Is.EqualTo(rows[i].numbers).Within(Rounding), $"{rows[i].label}\n{computed}");
            }
        }

        // Cells of the rows of the first table, without its head.
        static string[][] Table(string heading) => File.ReadAllLines(Path.Combine(
                Path.GetDirectoryName(Application.dataPath), "Packages/com.glint.radar/Documentation~/clutter.md"))
            .SkipWhile(line => line != heading).SkipWhile(line => !line.StartsWith("|"))
            .TakeWhile(line => line.StartsWith("|")).Skip(2)
            .Select(line => line.Trim('|').Split('|').Select(cell => cell.Trim()).ToArray()).ToArray();

        static string Text(double value)
        {
            double rounded = Math.Round(value, 1);
            return (rounded == 0 ? 0 : rounded).ToString("0.0", CultureInfo.InvariantCulture);
        }
    }
}
