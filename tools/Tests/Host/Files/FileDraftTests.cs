using System;
using System.Diagnostics;
using System.IO;
using System.Text;
using System.Threading.Tasks;
using Glint.Cli;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>Files that appear whole or not at all, and what a move would replace: links and pipes.</summary>
[Platform("Linux")]
public sealed class FileDraftTests
{
    string _folder, _file;

    [SetUp]
    public void MakeFile()
    {
        _folder = Directory.CreateTempSubdirectory("glint-draft-").FullName;
        _file = At("file");
        File.WriteAllText(_file, "older");
    }

    [TearDown]
    public void RemoveFolder() => Directory.Delete(_folder, true);

    [Test]
    public void File_IsTheOlderOne_UntilTheDraftIsFinished()
    {
        using (var draft = new FileDraft(_file))
        {
            draft.Stream.Write("new"u8);
            draft.Stream.Flush();
            Assert.That(File.ReadAllText(_file), Is.EqualTo("older"));
            draft.Finish();
        }
        Assert.That(File.ReadAllText(_file), Is.EqualTo("new"));
        Assert.That(Directory.GetFiles(_folder), Is.EqualTo(new[] { _file }));
    }

    /// <summary>Both would write one draft: the second is refused before its work, and the first is whole.</summary>
    [Test]
    public void Draft_BesideAnotherOneOfTheSameFile_IsRefused()
    {
        using (var draft = new FileDraft(_file))
        {
            draft.Stream.Write("new"u8);
            Assert.That(() => new FileDraft(_file), Throws.InstanceOf<IOException>());
            Assert.That(() => FileDraft.Check(_file), Throws.InstanceOf<IOException>());
            draft.Finish();
        }
        Assert.That(File.ReadAllText(_file), Is.EqualTo("new"));
    }

    [Test]
    public void Output_WhoseWritingFails_LeavesTheOlderFile()
    {
        var output = new OutputFile("--json", _file);
        Assert.That(() => output.Write(stream =>
        {
            stream.Write("half"u8);
            throw new IOException("No space left on device.");
        }), Throws.TypeOf<GlintException>().With.Message
            .EqualTo($"--json {_file}: cannot be written: No space left on device; name another file"));
        Assert.That(File.ReadAllText(_file), Is.EqualTo("older"));
        Assert.That(Directory.GetFiles(_folder), Is.EqualTo(new[] { _file }));
    }

    [Test]
    public void Output_ThatIsChecked_LeavesTheFolderAsItWas()
    {
        _ = new OutputFile("--json", _file);
        _ = new OutputFile("--json", At("new"));
        Assert.That(Directory.GetFiles(_folder), Is.EqualTo(new[] { _file }));
        Assert.That(File.ReadAllText(_file), Is.EqualTo("older"));
    }

    /// <summary>The work may take hours, and the draft needs a place too.</summary>
    [Test]
    public void Output_WhoseDraftHasNoPlace_IsRefusedBeforeTheWork()
    {
        Directory.CreateDirectory(_file + ".tmp");
        Assert.That(() => new OutputFile("--json", _file), Throws.TypeOf<GlintException>());
    }

    [TestCase("file")]
    [TestCase("missing")]
    public void Output_ToALink_IsWrittenToTheFileThatItNames(string target)
    {
        File.CreateSymbolicLink(At("link"), At(target));
        new OutputFile("--json", At("link")).Write(Put("new"));
        Assert.That(new FileInfo(At("link")).LinkTarget, Is.EqualTo(At(target)));
        Assert.That(File.ReadAllText(At(target)), Is.EqualTo("new"));
    }

    [Test]
    public void Pipe_GetsTheContent()
    {
        using (var maker = Process.Start("mkfifo", [At("pipe")]))
            maker.WaitForExit();
        var read = Task.Run(() => File.ReadAllText(At("pipe")));
        var written = Task.Run(() => FileDraft.Write(At("pipe"), Put("new")));
        Assert.That(Task.WaitAll([read, written], TimeSpan.FromSeconds(5)));
        Assert.That(read.Result, Is.EqualTo("new"));
    }

    static Action<Stream> Put(string text) => stream => stream.Write(Encoding.UTF8.GetBytes(text));

    string At(string name) => Path.Combine(_folder, name);
}
