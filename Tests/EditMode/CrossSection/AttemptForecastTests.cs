using System;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class AttemptForecastTests
    {
        const double First = 1.0 / 64, Min = 1.0 / (1 << 17);

        // Errors that fall with the power 0.6 are 50 times smaller after 9.4 halvings of the first error, and 1,000 times after
        // 16.6: 11 lead to the least one.
        [TestCase(50, ExpectedResult = true)]
        [TestCase(1000, ExpectedResult = false)]
        public bool Errors_OfAPower_AreExtrapolated(double excess)
        {
            var forecast = new AttemptForecast();
            Assert.That(forecast.CanBeMet(excess, First, Min));
            return forecast.CanBeMet(excess * Math.Pow(64, -0.6), First / 64, Min);
        }

        // The sum of 1/x down to a border whose place is known to a cell: it grows by as much with each halving.
        [Test]
        public void Errors_ThatHardlyFall_EndTheAttempts()
        {
            var forecast = new AttemptForecast();
            double ErrorOf(double cell) => 2 + 0.02 * Math.Log(cell / Min, 2);
            Assert.That(forecast.CanBeMet(ErrorOf(First), First, Min));
            Assert.That(forecast.CanBeMet(ErrorOf(First / 8), First / 8, Min), "8 times are too few to tell");
            Assert.That(forecast.CanBeMet(ErrorOf(First / 64), First / 64, Min), Is.False);
        }

        [Test]
        public void Errors_ThatGrow_EndTheAttempts()
        {
            var forecast = new AttemptForecast();
            Assert.That(forecast.CanBeMet(2, First, Min));
            Assert.That(forecast.CanBeMet(3, First / 64, Min), Is.False);
        }
    }
}
