using System;
using System.IO;
using System.Text;

namespace Glint.Cli;

/// <summary>
/// A standard stream that may be closed or full. Failures go to a callback instead of being thrown by the stream.
/// </summary>
/// <param name="inner">The stream.</param>
/// <param name="onFailure">Called with each failure; may throw.</param>
sealed class GuardedWriter(TextWriter inner, Action<Exception> onFailure) : TextWriter(inner.FormatProvider)
{
    public override Encoding Encoding => inner.Encoding;

    public override void Write(char value) => Try(() => inner.Write(value));

    public override void Write(char[] buffer, int index, int count) => Try(() => inner.Write(buffer, index, count));

    public override void Write(string value) => Try(() => inner.Write(value));

    // One write a line, so that lines of two threads do not mix.
    public override void WriteLine(string value) => Try(() => inner.WriteLine(value));

    public override void Flush() => Try(inner.Flush);

    void Try(Action write)
    {
        try
        {
            write();
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException or ObjectDisposedException)
        {
            onFailure(error);
        }
    }
}
