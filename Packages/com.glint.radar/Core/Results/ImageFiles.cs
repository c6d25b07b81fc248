using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text;
using System.Threading.Tasks;

namespace Glint.Core
{
    /// <summary>The files of the image of a sweep, written from the rows of a whole run.</summary>
    static class ImageFiles
    {
        // Decibels from white to black.
        const double Span = 60;

        /// <summary>image.csv, image.npz and a picture for each polarisation.</summary>
        public static readonly IReadOnlyList<WholeFile> All = new[]
        {
            new WholeFile("image.csv", WriteTable, HasImage) { IsOfImage = true },
            new WholeFile("image.npz", WriteNumpy, HasImage) { IsOfImage = true }
        }.Concat(Polarisation.All.Select(polarisation => new WholeFile($"image-{polarisation}.png",
            (output, run) => WritePicture(output, run.Echo.Image(polarisation)),
            run => HasImage(run) && run.Echo.Polarisations.Contains(polarisation))
        { IsOfImage = true })).ToArray();

        static bool HasImage(WholeRun run) => run.Echo.Settings.Image != null;

        // A line for each pixel.
        static void WriteTable(Stream output, WholeRun run)
        {
            var echo = run.Echo;
            var transform = echo.NewImage();
            var images = Polarisation.All.Select(echo.Image).ToArray();
            int pixels = transform.Pixels;
            string[] places = Enumerable.Range(0, pixels).Select(i => Numbers.Format(transform.PlaceOf(i))).ToArray();
            using (var text = new StreamWriter(output, new UTF8Encoding(false), 1 << 16, true) { NewLine = "\n" })
            {
                text.WriteLine("down_range_m,cross_range_m,"
                    + string.Join(",", Polarisation.All.Select(each => $"{each}_dbsm")));
                var rows = new string[pixels];
                Parallel.For(0, pixels, row => rows[row] = RowOf(images, places, row));
                foreach (string row in rows)
                    text.Write(row);
            }
        }

        static string RowOf(Complex[][] images, string[] places, int row)
        {
            var text = new StringWriter(CultureInfo.InvariantCulture) { NewLine = "\n" };
            for (int column = 0; column < places.Length; column++)
            {
                text.Write(places[row]);
                text.Write(',');
                text.Write(places[column]);
                EchoFiles.WriteLevels(text, images, row * places.Length + column);
            }
            return text.ToString();
        }

        static void WriteNumpy(Stream output, WholeRun run)
        {
            var echo = run.Echo;
            var transform = echo.NewImage();
            int pixels = transform.Pixels;
            var places = Enumerable.Range(0, pixels).Select(index => transform.PlaceOf(index)).ToArray();
            var empty = new Lazy<Complex[]>(() =>
                Enumerable.Repeat(new Complex(double.NaN, double.NaN), pixels * pixels).ToArray());
            using (var file = new NumpyArchive(output))
            {
                file.Add("down_range", new[] { pixels }, places);
                file.Add("cross_range", new[] { pixels }, places);
                file.Add("image", new[] { 2, 2, pixels, pixels }, Polarisation.Matrix.SelectMany(polarisation =>
                    echo.Image(polarisation) ?? empty.Value));
            }
        }

        // As seen by the radar from above: near pixels below, those to its right on the right.
        static void WritePicture(Stream output, Complex[] image)
        {
            int pixels = (int)Math.Round(Math.Sqrt(image.Length));
            double[] levels = image.Select(value => ScatteringMatrix.Dbsm(value)).ToArray();
            double highest = levels.Max();
            PngFile.WriteGrey(output, pixels, Enumerable.Range(0, image.Length).Select(i =>
            {
                double below = highest - levels[(pixels - 1 - i / pixels) * pixels + i % pixels];
                return (byte)Math.Round(255 * Math.Max(0, 1 - below / Span));
            }).ToArray());
        }
    }
}
