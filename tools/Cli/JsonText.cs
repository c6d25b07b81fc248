using System.IO;
using System.Text;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace Glint.Cli;

/// <summary>Figures as indented JSON text in UTF-8 with the project's line ends.</summary>
static class JsonText
{
    /// <summary>Writes an object and a line end, and closes the stream.</summary>
    public static void Write(Stream stream, JObject root)
    {
        using var json = new JsonTextWriter(
            new StreamWriter(stream, new UTF8Encoding(false)) { NewLine = "\n" })
        { Formatting = Formatting.Indented };
        root.WriteTo(json);
        json.WriteWhitespace("\n");
    }
}
