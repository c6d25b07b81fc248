using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using System.Xml;
using static Glint.Cli.TableText;

namespace Glint.Cli;

/// <summary>
/// An SVG picture on white: lines, dots and texts. The origin is the upper left corner; coordinates are rounded to
/// 0.1.
/// </summary>
sealed class Svg : IDisposable
{
    const string Namespace = "http://www.w3.org/2000/svg";

    readonly XmlWriter _svg;

    public Svg(Stream stream, int width, int height)
    {
        _svg = XmlWriter.Create(stream, new XmlWriterSettings
        {
            Encoding = new UTF8Encoding(false), Indent = true, NewLineChars = "\n", OmitXmlDeclaration = true
        });
        _svg.WriteStartElement("svg", Namespace);
        Attributes(("viewBox", $"0 0 {width} {height}"), ("width", width), ("height", height),
            ("font-family", "sans-serif"), ("font-size", 13));
        Element("rect", ("width", width), ("height", height), ("fill", "white"));
    }

    /// <summary>Ends the picture; the stream remains open.</summary>
    public void Dispose() => _svg.Dispose();

    public void Dot(double x, double y, string colour, bool isHollow, double radius = 4) =>
        Element("circle", ("cx", Rounded(x)), ("cy", Rounded(y)), ("r", radius), ("stroke", colour),
            ("stroke-width", 1.5), ("fill", isHollow ? "white" : colour));

    public void Line(double x1, double y1, double x2, double y2, string colour, double thickness = 1) =>
        Element("line", ("x1", Rounded(x1)), ("y1", Rounded(y1)), ("x2", Rounded(x2)), ("y2", Rounded(y2)),
            ("stroke", colour), ("stroke-width", thickness));

    public void Polyline(IEnumerable<(double x, double y)> points, string colour, double thickness = 1.5) =>
        Element("polyline", ("points", Points(points)), ("fill", "none"), ("stroke", colour),
            ("stroke-width", thickness));

    /// <summary>A translucent area.</summary>
    public void Area(IEnumerable<(double x, double y)> outline, string colour) =>
        Element("polygon", ("points", Points(outline)), ("fill", colour), ("fill-opacity", 0.2));

    public void Rectangle(double x, double y, double width, double height, string colour) =>
        Element("rect", ("x", Rounded(x)), ("y", Rounded(y)), ("width", Rounded(width)),
            ("height", Rounded(height)), ("fill", colour));

    /// <summary>Rows of pixels, one unit high, with sizes in units.</summary>
    public void Pixels(double x, double y, double size, string colour, IEnumerable<(int x, int y, int length)> runs) =>
        Element("path", ("transform", Text($"translate({x:0.#} {y:0.#}) scale({size:0.####})")),
        ("fill", colour), ("shape-rendering", "crispEdges"),
            ("d", string.Concat(runs.Select(run => Text($"M{run.x} {run.y}h{run.length}v1h-{run.length}z")))));

    /// <param name="anchor">Which end of the text is at the position: start, middle or end.</param>
    public void Write(double x, double y, string text, string anchor, params (string name, object value)[] more)
    {
        _svg.WriteStartElement("text", Namespace);
        Attributes([("x", Rounded(x)), ("y", Rounded(y)), ("text-anchor", anchor), .. more]);
        _svg.WriteString(text);
        _svg.WriteEndElement();
    }

    void Element(string name, params (string name, object value)[] attributes)
    {
        _svg.WriteStartElement(name, Namespace);
        Attributes(attributes);
        _svg.WriteEndElement();
    }

    void Attributes(params (string name, object value)[] attributes)
    {
        foreach (var (name, value) in attributes)
            _svg.WriteAttributeString(name, Convert.ToString(value, CultureInfo.InvariantCulture));
    }

    static string Points(IEnumerable<(double x, double y)> points) =>
        string.Join(" ", points.Select(point => Text($"{point.x:0.0},{point.y:0.0}")));

    static double Rounded(double point) => Math.Round(point, 1);
}
