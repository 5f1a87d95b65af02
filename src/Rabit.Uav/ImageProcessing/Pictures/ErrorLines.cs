using System;
using System.IO;
using System.Text;
using System.Threading;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Reads what a program writes to its standard error, line by line, on a thread of its own. The runtime's own reader
/// keeps a line until its end comes, however long it gets; here what is behind the first bytes is dropped, so that a
/// program that never ends its line costs no memory.
/// </summary>
internal sealed class ErrorLines : IDisposable
{
    private const int MaxLineBytes = 500;
    private const string More = " ...";

    private readonly Stream _errors;
    private readonly Action<string> _onLine;
    private readonly Thread _thread;
    private readonly byte[] _line = new byte[MaxLineBytes];
    private int _length;      // of the line, up to its limit
    private bool _isPassed;   // it was too long, and its begin has been passed on
    private volatile bool _isOver;

    /// <param name="errors">What the program writes; closed at its end.</param>
    /// <param name="onLine">Called by the thread for each line that is not empty.</param>
    public ErrorLines(Stream errors, Action<string> onLine)
    {
        (_errors, _onLine) = (errors, onLine);
        _thread = new Thread(Read) { IsBackground = true, Name = "errors of a camera" };
        _thread.Start();
    }

    /// <summary>Waits for the end of what the program writes; false if it has not come.</summary>
    public bool TryWait(int milliseconds) => _thread.Join(milliseconds);

    /// <summary>Passes no more lines on. The thread ends when all that hold the pipe have.</summary>
    public void Dispose() => _isOver = true;

    private void Read()
    {
        byte[] bytes = new byte[4096];
        using (_errors)
        {
            while (ReadInto(bytes) is > 0 and int count)
            {
                foreach (byte next in bytes.AsSpan(0, count))
                    Add(next);
            }
        }

        EndLine();
    }

    private int ReadInto(byte[] bytes)
    {
        try
        {
            return _errors.Read(bytes, 0, bytes.Length);
        }
        catch (Exception e) when (e is IOException or ObjectDisposedException)
        {
            return 0;   // it was killed
        }
    }

    private void Add(byte next)
    {
        if (next is (byte)'\n' or (byte)'\r')
        {
            EndLine();
        }
        else if (_length < MaxLineBytes)
        {
            _line[_length++] = next;
        }
        else if (!_isPassed)
        {
            // At once: its end may never come.
            Pass(Text() + More);
            _isPassed = true;
        }
    }

    private void EndLine()
    {
        if (!_isPassed && Text() is var text && !string.IsNullOrWhiteSpace(text))
            Pass(text);
        (_length, _isPassed) = (0, false);
    }

    // A character may have been cut in two.
    private string Text() => Encoding.UTF8.GetString(_line, 0, _length).TrimEnd('\uFFFD');

    private void Pass(string line)
    {
        if (!_isOver)
            _onLine(line);
    }
}
