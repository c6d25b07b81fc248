using NUnit.Framework;

namespace Glint.Tests
{
    public class SliceForecastTests
    {
        const long MaxRays = 1000;

        // 5 rays a cell are assumed.
        [Test]
        public void FirstAttempt_HasCellsOfTheRaysAssumed() =>
            Assert.That(CellsFrom(Begun(1), 0, 5000), Is.EqualTo(200));

        // 100 cells of one ray, then cells of 20: at the same error the slice has the first and 45 of the others.
        [Test]
        public void Slice_HasTheRaysOfTheAttemptBefore()
        {
            var forecast = Begun(1);
            forecast.Took(0, 100, new long[] { 100 });
            forecast.Took(100, 400, new long[] { 8000 });
            forecast.Begin(1);
            Assert.That(CellsFrom(forecast, 0, 500), Is.EqualTo(100 + 45));
            Assert.That(CellsFrom(forecast, 145, 355), Is.EqualTo(50));
            Assert.That(CellsFrom(forecast, 145, 20), Is.EqualTo(20), "no more than asked for");
            Assert.That(CellsFrom(forecast, 480, 20), Is.EqualTo(20));
        }

        // Of 10 cells in 4 parts the kernels count 3, 2, 3 and 2.
        [Test]
        public void Parts_AreThoseOfTheKernels()
        {
            var forecast = Begun(1);
            forecast.Took(0, 10, new long[] { 3, 200, 3, 2 });
            forecast.Begin(1);
            double left = MaxRays;
            Assert.That(forecast.CellsFrom(0, 3, ref left), Is.EqualTo(3));
            Assert.That(left, Is.EqualTo(MaxRays - 3));
            forecast.CellsFrom(3, 2, ref left);
            Assert.That(left, Is.EqualTo(MaxRays - 203));
            forecast.CellsFrom(5, 5, ref left);
            Assert.That(left, Is.EqualTo(MaxRays - 208));
        }

        // 20 million rays where 5,000 were forecast: the next slice has a quarter of the cells.
        [Test]
        public void Slice_IsShorterAfterOneOfManyRays()
        {
            var forecast = Begun(1);
            forecast.Took(0, 1000, new long[] { 20_000_000 });
            Assert.That(CellsFrom(forecast, 1000, 5000), Is.EqualTo(50));
        }

        // A smaller error takes more rays, but no more than in proportion.
        [Test]
        public void Slice_IsShorterForASmallerError()
        {
            var forecast = Begun(1);
            forecast.Took(0, 1000, new long[] { 1000 });
            forecast.Begin(0.125);
            Assert.That(CellsFrom(forecast, 0, 1000), Is.InRange(125, 500));
        }

        // The rays that a slice does not take are left for those of other poses.
        [Test]
        public void Slice_LeavesRays()
        {
            var forecast = Begun(1);
            forecast.Took(0, 10, new long[] { 300 });
            forecast.Begin(1);
            double left = MaxRays;
            Assert.That(forecast.CellsFrom(0, 10, ref left), Is.EqualTo(10));
            Assert.That(left, Is.EqualTo(700));
        }

        static long CellsFrom(SliceForecast forecast, long first, long max)
        {
            double left = MaxRays;
            return forecast.CellsFrom(first, max, ref left);
        }

        static SliceForecast Begun(double error)
        {
            var forecast = new SliceForecast();
            forecast.Begin(error);
            return forecast;
        }
    }
}
