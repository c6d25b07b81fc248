using System.Linq;
using NUnit.Framework;
using YamlDotNet.RepresentationModel;

namespace Glint.Host.Tests;

/// <summary>Long hexadecimal values go around the parser, which must not be seen in a document.</summary>
public sealed class HexValuesTests
{
    static readonly string _hex = string.Concat(Enumerable.Range(0, 3000).Select(i => (i % 256).ToString("x2")));

    [Test]
    public void Values_InLinesOfTheirOwn_AreThoseWritten()
    {
        var fields = Fields($"  m_Before: 0\n  m_Bytes: {_hex}\r\n  m_Inner:\n    m_More: {_hex}aa\n  m_After: 0\n");
        Assert.That(Text(fields, "m_Before"), Is.EqualTo("0"));
        Assert.That(Text(fields, "m_Bytes"), Is.EqualTo(_hex));
        Assert.That(Text((YamlMappingNode)fields.Child("m_Inner"), "m_More"), Is.EqualTo(_hex + "aa"));
        Assert.That(Text(fields, "m_After"), Is.EqualTo("0"));
    }

    [Test]
    public void Values_AtTheEndOfAListsItem_AreThoseWritten()
    {
        var list = (YamlSequenceNode)Fields($"  m_List:\n  - m_Bytes: {_hex}\n  - m_Bytes: {_hex}ff").Child("m_List");
        Assert.That(list.Children.Cast<YamlMappingNode>().Select(item => Text(item, "m_Bytes")),
            Is.EqualTo(new[] { _hex, _hex + "ff" }));
    }

    [Test]
    public void Text_ThatOnlyLooksLikeAValue_StaysAsItIs() =>
        Assert.That(Text(Fields($"  m_Script: \"first\n    m_Bytes: {_hex}\n    last\"\n  m_After: 0\n"), "m_Script"),
            Is.EqualTo($"first m_Bytes: {_hex} last"));

    static YamlMappingNode Fields(string text) =>
        UnityFile.Parse("%YAML 1.1\n--- !u!114 &1\nMonoBehaviour:\n" + text, "text").Documents.Single().Fields;

    static string Text(YamlMappingNode fields, string key) => ((YamlScalarNode)fields.Child(key)).Value;
}
