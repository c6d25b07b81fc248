using System;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>Ships that move and turn.</summary>
    public sealed class UnderwayTests
    {
        // A circle of the radius speed over rate of turn, whatever the step.
        [TestCase(180, 1)]
        [TestCase(180, 900)]
        [TestCase(600, 1)]
        [TestCase(1080, 1)]
        public void Advance_OfAShipThatTurns_IsOnItsCircle(double seconds, int steps)
        {
            var ship = new GameObject("Ship").AddComponent<Underway>();
            try
            {
                (ship.SpeedKnots, ship.TurnDegreesAMinute) = (5, 20);
                for (int step = 0; step < steps; step++)
                    ship.Advance(seconds / steps);
                double speed = 5 * 1852 / 3600.0, rate = 20 / 60.0 * Math.PI / 180, radius = speed / rate,
                    angle = rate * seconds;
                Assert.That(ship.transform.position.x, Is.EqualTo(radius * (1 - Math.Cos(angle))).Within(0.02));
                Assert.That(ship.transform.position.z, Is.EqualTo(radius * Math.Sin(angle)).Within(0.02));
                Assert.That(Vector3.Angle(ship.transform.forward,
                    new Vector3((float)Math.Sin(angle), 0, (float)Math.Cos(angle))), Is.LessThan(0.05));
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(ship.gameObject);
            }
        }
    }
}
