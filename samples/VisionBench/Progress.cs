using System;
using System.IO;

namespace VisionBench;

/// <summary>A bar of what is done, in one line of a terminal; where there is none, nothing.</summary>
internal sealed class Progress(TextWriter errors, bool isTerminal) : IDisposable
{
    private const int Width = 30;

    private int _length;

    public void Show(string name, int done, int of)
    {
        if (!isTerminal)
            return;
        string text = $"{name} [{new string('=', Width * done / of),-Width}] {done} of {of}";
        errors.Write("\r" + text);
        _length = Math.Max(_length, text.Length);
    }

    /// <summary>Leaves an empty line, for what is written next.</summary>
    public void Clear()
    {
        if (_length > 0)
            errors.Write("\r" + new string(' ', _length) + "\r");
        _length = 0;
    }

    public void Dispose() => Clear();
}
