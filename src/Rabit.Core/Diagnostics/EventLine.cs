using System;
using System.IO;

namespace Rabit.Core.Diagnostics;

/// <summary>
/// One line of the event log in the making: seconds, who, what. Always the same characters, whatever the culture and
/// the platform.
/// </summary>
internal sealed class EventLine
{
    private const int TimeWidth = 14;
    private char[] _text = new char[256];
    private int _length;
    private TimeSpan _instant;    // whose text the line begins with
    private int _prefixLength;

    public EventLine Begin(TimeSpan now, string source)
    {
        // Many lines of one instant follow each other: its text is left where it is.
        if (now != _instant || _prefixLength == 0)
            WritePrefix(now);
        _length = _prefixLength;
        return Add(source).Add(": ");
    }

    /// <summary>Keeps to its line: a line break becomes a space.</summary>
    public EventLine Add(string text)
    {
        EnsureRoom(text.Length);
        text.CopyTo(0, _text, _length, text.Length);
        if (text.AsSpan().IndexOfAny('\r', '\n') >= 0)
            Flatten(_length, text.Length);
        _length += text.Length;
        return this;
    }

    public EventLine Add(long number)
    {
        if (number < 0)
            Add('-');
        return AddDigits(number < 0 ? unchecked(0 - (ulong)number) : (ulong)number, 1);
    }

    /// <summary>Seconds, exact: the seventh digit is a tick.</summary>
    public EventLine Add(TimeSpan time)
    {
        if (time < TimeSpan.Zero)
            Add('-');
        ulong ticks = time < TimeSpan.Zero ? unchecked(0 - (ulong)time.Ticks) : (ulong)time.Ticks;
        AddDigits(ticks / TimeSpan.TicksPerSecond, 1);
        Add('.');
        return AddDigits(ticks % TimeSpan.TicksPerSecond, 7);
    }

    public void WriteTo(TextWriter writer)
    {
        Add('\n');
        writer.Write(_text, 0, _length);
    }

    private void WritePrefix(TimeSpan now)
    {
        _length = 0;
        Add(now);
        int width = Math.Max(_length, TimeWidth);
        EnsureRoom(width - _length + 1);
        Array.Copy(_text, 0, _text, width - _length, _length);
        for (int i = 0; i < width - _length; i++)
            _text[i] = ' ';
        _text[width] = ' ';
        _prefixLength = width + 1;
        _instant = now;
    }

    private void Flatten(int start, int length)
    {
        for (int i = start; i < start + length; i++)
        {
            if (_text[i] is '\r' or '\n')
                _text[i] = ' ';
        }
    }

    private EventLine AddDigits(ulong number, int minDigits)
    {
        if (number >= 10 || minDigits > 1)
            AddDigits(number / 10, minDigits - 1);
        Add((char)('0' + (number % 10)));
        return this;
    }

    private void Add(char c)
    {
        EnsureRoom(1);
        _text[_length++] = c;
    }

    private void EnsureRoom(int more)
    {
        if (_length + more > _text.Length)
            Array.Resize(ref _text, (_length + more) * 2);
    }
}
