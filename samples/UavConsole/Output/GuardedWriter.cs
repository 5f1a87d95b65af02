using System;
using System.IO;
using System.Text;

namespace UavConsole;

/// <summary>
/// Standard output that may be full, closed or gone: what cannot be written is counted and the flight goes on.
/// </summary>
/// <param name="inner">Standard output.</param>
internal sealed class GuardedWriter(TextWriter inner) : TextWriter
{
    private readonly object _gate = new();   // guards the two below
    private long _lost;
    private string? _failure;

    public override Encoding Encoding => inner.Encoding;

    /// <summary>What was lost, as a sentence; null where nothing was. Any thread.</summary>
    public string? Loss
    {
        get
        {
            lock (_gate)
                return _failure is null ? null : $"standard output: {_lost} writes were lost: {_failure}";
        }
    }

    public override void Write(char value) => Guard(() => inner.Write(value));

    public override void Write(char[] buffer, int index, int count)
        => Guard(() => inner.Write(buffer, index, count));

    public override void Write(string? value) => Guard(() => inner.Write(value));

    public override void WriteLine(string? value) => Guard(() => inner.WriteLine(value));

    public override void Flush() => Guard(inner.Flush);

    private void Guard(Action write)
    {
        try
        {
            write();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ObjectDisposedException)
        {
            lock (_gate)
            {
                _lost++;
                _failure ??= e.Message;
            }
        }
    }
}
