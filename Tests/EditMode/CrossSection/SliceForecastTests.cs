using NUnit.Framework;

namespace Glint.Tests
{
    public class SliceForecastTests
    {
        const long MaxRays = 1000;

        [Test]
        public void FirstAttempt_IsNotCut() =>
            Assert.That(Begun(1).CellsFrom(0, 5000), Is.EqualTo(5000));

        // 100 cells of one ray, then cells of 20: at the same error the slice has the first and 45 of the others.
        [Test]
        public void Slice_HasTheRaysOfTheAttemptBefore()
        {
            var forecast = Begun(1);
            forecast.Took(0, 100, 100);
            forecast.Took(100, 400, 8000);
            forecast.Begin(1);
            Assert.That(forecast.CellsFrom(0, 500), Is.EqualTo(100 + 45));
            Assert.That(forecast.CellsFrom(145, 355), Is.EqualTo(50));
            Assert.That(forecast.CellsFrom(145, 20), Is.EqualTo(20), "no more than asked for");
            Assert.That(forecast.CellsFrom(480, 20), Is.EqualTo(20));
        }

        // A smaller error takes more rays, but no more than in proportion.
        [Test]
        public void Slice_IsShorterForASmallerError()
        {
            var forecast = Begun(1);
            forecast.Took(0, 1000, 1000);
            forecast.Begin(0.125);
            Assert.That(forecast.CellsFrom(0, 1000), Is.InRange(125, 500));
        }

        [Test]
        public void Slice_HasACell()
        {
            var forecast = Begun(1);
            forecast.Took(0, 1, 1000000);
            forecast.Begin(0.001);
            Assert.That(forecast.CellsFrom(0, 1), Is.EqualTo(1));
        }

        static SliceForecast Begun(double error)
        {
            var forecast = new SliceForecast(MaxRays);
            forecast.Begin(error);
            return forecast;
        }
    }
}
