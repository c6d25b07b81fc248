using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Glint.Core;
using Glint.Tests;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Host.Tests;

/// <summary>A scene of a few bodies before a radar that looks along the scene's z axis.</summary>
/// <param name="Size">Half the height of the view, m.</param>
/// <param name="Range">Distance from the radar to the centre, m.</param>
/// <param name="At">The centre, m.</param>
/// <param name="Turn">Rotation of bodies and radar together.</param>
/// <param name="Receiver">Side of the receiver, m.</param>
sealed record RandomScene(RandomBody[] Bodies, double Size, double Range, bool IsParallel, double3 At, double4 Turn,
    double Receiver, int Bounces)
{
    public const int RaysAcross = 64, RaysDown = 36;

    static readonly double4 NoTurn = double4(0, 0, 0, 1);

    Affine Transform => Affine.FromTransform(At, Turn, 1);

    public RadarScene Scene => new([.. Bodies.Select(body => body.Placed(Transform))]);

    public RadarSettings Settings => TestRadar.Settings(RaysAcross, RaysDown, Bounces);

    public RadarView View
    {
        get
        {
            var transform = Transform;
            double3 camera = transform.Point(double3(0, 0, -Range));
            return new RadarView
            {
                Position = camera, Right = normalize(transform.X),
                Up = normalize(transform.Y), Forward = normalize(transform.Z),
                VerticalFovDegrees = degrees(2 * atan(Size / Range)), ApertureHeight = IsParallel ? 2 * Size : 0,
                ReceiverCentre = camera, ReceiverRight = normalize(transform.X), ReceiverUp = normalize(transform.Y),
                ReceiverForward = normalize(transform.Z), ReceiverSize = Receiver,
            };
        }
    }

    public IEnumerable<RandomScene> Simpler()
    {
        for (int i = 0; i < Bodies.Length && Bodies.Length > 1; i++)
            yield return this with { Bodies = [.. Bodies[..i], .. Bodies[(i + 1)..]] };
        if (any(At != 0))
            yield return this with { At = 0 };
        if (any(Turn != NoTurn))
            yield return this with { Turn = NoTurn };
        if (IsParallel)
            yield return this with { IsParallel = false };
        if (Bounces > 1)
            yield return this with { Bounces = Bounces - 1 };
        for (int i = 0; i < Bodies.Length; i++)
            foreach (var simpler in Bodies[i].Simpler())
                yield return this with { Bodies = [.. Bodies[..i], simpler, .. Bodies[(i + 1)..]] };
    }

    public override string ToString() => string.Create(CultureInfo.InvariantCulture,
        $"picture of {2 * Size:R} m from {Range:R} m{(IsParallel ? ", parallel rays" : "")}, middle at {RandomBody.Text(At)}, turned ({Turn.x:R} {Turn.y:R} {Turn.z:R} {Turn.w:R}), receiver {Receiver:R} m, {Bounces} bounces\n")
        + string.Concat(Bodies.Select(body => $"  {body}\n"));
}
