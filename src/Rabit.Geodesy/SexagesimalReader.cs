using System;
using System.Globalization;

namespace Rabit.Geodesy;

/// <summary>
/// Reads one coordinate after the other from a text: degrees, with minutes and seconds where their marks are there. For
/// one thread.
/// </summary>
internal sealed class SexagesimalReader(string text)
{
    private int _at;

    /// <summary>Whether nothing is left.</summary>
    public bool IsAtEnd
    {
        get
        {
            SkipBlanks();
            return _at == text.Length;
        }
    }

    /// <summary>Reads one, degrees.</summary>
    /// <param name="degrees">South and west negative.</param>
    /// <param name="letter">N, S, E or W, before or after it; a blank if there is none.</param>
    public bool TryRead(out double degrees, out char letter)
    {
        degrees = 0;
        letter = TakeLetter();
        SkipBlanks();
        double sign = 1;
        if (_at < text.Length && text[_at] is '-' or '+')
            sign = text[_at++] == '-' ? -1 : 1;
        if (!TryNumber(out degrees) || degrees < 0)
            return false;
        bool hasMark = TakeMark("°dº");
        if (hasMark && IsDigitNext())
        {
            if (degrees != Math.Floor(degrees) || !TryPart("'′m", 60, ref degrees))
                return false;
            if (IsDigitNext()
                && (degrees * 60 % 1 > 1e-9 && degrees * 60 % 1 < 1 - 1e-9 || !TryPart("\"″s", 3600, ref degrees)))
                return false;
        }

        // A letter after it is the next one's where this one had its letter before.
        if (letter == ' ')
            letter = TakeLetter();
        if (sign < 0 && letter != ' ')
            return false;
        degrees *= letter is 'S' or 'W' ? -1 : sign;
        SkipBlanks();
        if (_at < text.Length && text[_at] == ',')
            _at++;
        return true;
    }

    private bool TryPart(string marks, double perDegree, ref double degrees)
    {
        if (!TryNumber(out double part) || part >= 60 || !TakeMark(marks))
            return false;
        degrees += part / perDegree;
        return true;
    }

    private bool TryNumber(out double number)
    {
        SkipBlanks();
        int start = _at;
        while (_at < text.Length && text[_at] is (>= '0' and <= '9') or '.')
            _at++;
        string digits = text.Substring(start, _at - start);
        return double.TryParse(digits, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out number);
    }

    private bool TakeMark(string marks)
    {
        SkipBlanks();
        if (_at == text.Length || marks.IndexOf(text[_at]) < 0)
            return false;
        _at++;
        return true;
    }

    private char TakeLetter()
    {
        SkipBlanks();
        if (_at == text.Length || "NSEWnsew".IndexOf(text[_at]) < 0)
            return ' ';
        return char.ToUpperInvariant(text[_at++]);
    }

    private bool IsDigitNext()
    {
        SkipBlanks();
        return _at < text.Length && text[_at] is >= '0' and <= '9';
    }

    private void SkipBlanks()
    {
        while (_at < text.Length && char.IsWhiteSpace(text[_at]))
            _at++;
    }
}
