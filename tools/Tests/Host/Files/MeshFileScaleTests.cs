using System.IO;
using System.Text;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Host.Tests;

public sealed class MeshFileScaleTests
{
    // Searching the joined line's first word again after each of its lines took an hour.
    [Test, MaxTime(20_000)]
    public void Obj_OfABlankLineContinuedAgainAndAgain_IsReadInProportionToItsSize()
    {
        var text = new StringBuilder().Insert(0, "\\\n", 4_000_000).Append("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        var mesh = MeshFileReader.Read(new MemoryStream(Encoding.ASCII.GetBytes(text.ToString())), "mesh.obj",
            LengthUnit.Parse("m"), UpAxis.Y);
        Assert.That(mesh.TriangleCount, Is.EqualTo(1));
    }
}
