using System;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Terminal;

namespace UavConsole.Tests;

/// <summary>
/// What a terminal shows of what is written to it: the few sequences that the screen uses, and resizing, by which lines
/// are cut off or added. Any other sequence is an error.
/// </summary>
internal sealed class TerminalEmulator(int columns, int rows) : TextWriter
{
    private readonly StringBuilder _written = new();
    private char[][] _page = NewPage(columns, rows);
    private (int Column, int Row) _cursor;
    private string? _sequence;

    public override Encoding Encoding => Encoding.UTF8;

    /// <summary>All that was written.</summary>
    public string Written => _written.ToString();

    public bool IsOnSecondPage { get; private set; }

    public bool HasCursor { get; private set; } = true;

    public (int Columns, int Rows) Size => (_page[0].Length, _page.Length);

    /// <summary>The lines as they stand there, without blanks at their ends.</summary>
    public string[] Lines => [.. _page.Select(r => new string(r).TrimEnd())];

    public ScreenTerminal Terminal(Spectre.Console.ColorSystem colours = Spectre.Console.ColorSystem.TrueColor)
        => new(this, () => Size, colours, isUnicode: true);

    public void Resize(int newColumns, int newRows)
    {
        char[][] before = _page;
        _page = NewPage(newColumns, newRows);
        for (int row = 0; row < Math.Min(newRows, before.Length); row++)
            Array.Copy(before[row], _page[row], Math.Min(newColumns, before[row].Length));
    }

    public override void Write(char value)
    {
        _written.Append(value);
        if (_sequence is not null)
            Continue(value);
        else if (value == '\u001b')
            _sequence = string.Empty;
        else if (value == '\n')
            _cursor = (0, Math.Min(_cursor.Row + 1, _page.Length - 1));
        else
            Put(value);
    }

    public override void Write(string? value)
    {
        foreach (char c in value ?? string.Empty)
            Write(c);
    }

    // Automatic wrap is off: what is too long stays in the last column.
    private void Put(char value)
    {
        if (char.IsControl(value))
            throw new InvalidOperationException($"Control character {(int)value}.");
        _page[_cursor.Row][Math.Min(_cursor.Column, Size.Columns - 1)] = value;
        _cursor.Column++;
    }

    private void Continue(char value)
    {
        _sequence += value;
        if (!char.IsLetter(value))
            return;
        string sequence = _sequence!;
        _sequence = null;
        switch (sequence)
        {
            case "[?1049h" or "[?1049l":
                IsOnSecondPage = value == 'h';
                break;
            case "[?25h" or "[?25l":
                HasCursor = value == 'h';
                break;
            case "[?7h" or "[?7l":
                break;
            case "[2J":
                _page = NewPage(Size.Columns, Size.Rows);
                break;
            case "[2K":
                _page[_cursor.Row] = NewPage(Size.Columns, 1)[0];
                break;
            default:
                Move(sequence, value);
                break;
        }
    }

    private void Move(string sequence, char kind)
    {
        if (kind == 'm')
            return;
        string[] numbers = sequence.Trim('[', 'H').Split(';');
        if (kind != 'H' || numbers.Length != 2)
            throw new InvalidOperationException($"Sequence {sequence}.");
        _cursor = (int.Parse(numbers[1], System.Globalization.CultureInfo.InvariantCulture) - 1,
            Math.Min(int.Parse(numbers[0], System.Globalization.CultureInfo.InvariantCulture), _page.Length) - 1);
    }

    private static char[][] NewPage(int columns, int rows)
        => [.. Enumerable.Range(0, rows).Select(_ => new string(' ', columns).ToCharArray())];
}
