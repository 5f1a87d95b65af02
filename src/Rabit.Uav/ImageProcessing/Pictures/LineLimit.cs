using System;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Lets lines of another program through to a log, which a talkative one must not fill: some in ten seconds, and then
/// how many more there were. Any thread.
/// </summary>
internal sealed class LineLimit(Action<string> log)
{
    private const int MaxLines = 20;
    private static readonly TimeSpan Window = TimeSpan.FromSeconds(10);

    private readonly object _gate = new();
    private TimeSpan _begun;
    private int _lines;

    public void Add(string line, TimeSpan now)
    {
        int held = 0;
        lock (_gate)
        {
            if (now - _begun >= Window)
            {
                held = Math.Max(0, _lines - MaxLines);
                (_begun, _lines) = (now, 0);
            }

            if (++_lines > MaxLines)
                return;
        }

        if (held > 0)
            log(FormattableString.Invariant($"{held} more lines in {Window.ExactSeconds} s, not shown"));
        log(line);
    }
}
