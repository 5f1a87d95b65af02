using System;
using System.Globalization;
using System.IO;
using System.Text;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace Rabit.Terminal;

/// <summary>
/// Draws a picture on the terminal's second page, again and again, line by line in its place: only lines that changed,
/// all after a change of size and every few seconds. A picture never scrolls, so that no size of before remains in it.
/// </summary>
internal sealed class ScreenPainter(ScreenTerminal terminal)
{
    // ECMA-48 and xterm: second page, cursor, automatic wrap.
    private const string Enter = "\u001b[?1049h\u001b[?25l\u001b[?7l";
    private const string Leave = "\u001b[?7h\u001b[?25h\u001b[?1049l";
    private const string Clear = "\u001b[0m\u001b[2J";
    private const string EraseLine = "\u001b[2K";

    // Another program may have written onto the screen, or the terminal lost it.
    private const int PicturesPerRepaint = 40;

    private string?[] _shown = [];
    private (int Columns, int Rows) _size;
    private int _pictures;

    public void Begin() => Write(Enter);

    /// <summary>Goes back to the first page and leaves the last picture there.</summary>
    public void End(Func<int, int, IRenderable> draw)
    {
        (int columns, int rows) = terminal.Size;
        Write(Leave + string.Join("\n", Lines(draw(columns, rows), columns, rows)) + "\n");
    }

    /// <param name="draw">Draws the picture in so many columns and lines.</param>
    public void Paint(Func<int, int, IRenderable> draw)
    {
        (int columns, int rows) = terminal.Size;
        var text = new StringBuilder();
        bool isResized = _size != (columns, rows);
        if (isResized)
            text.Append(Clear);
        if (isResized || ++_pictures >= PicturesPerRepaint)
            (_shown, _pictures) = (new string?[rows], 0);
        _size = (columns, rows);
        string[] lines = Lines(draw(columns, rows), columns, rows);
        for (int row = 0; row < rows; row++)
        {
            string line = row < lines.Length ? lines[row] : string.Empty;
            if (line == _shown[row])
                continue;
            _shown[row] = line;
            text.AppendFormat(CultureInfo.InvariantCulture, "\u001b[{0};1H", row + 1).Append(EraseLine).Append(line);
        }

        if (text.Length > 0)
            Write(text.ToString());
    }

    // What is longer than the screen is left out at the end.
    private string[] Lines(IRenderable picture, int columns, int rows)
    {
        using var text = new StringWriter();
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.Yes,
            ColorSystem = ColorSystemSupport.NoColors,
            Interactive = InteractionSupport.No,
            Out = new AnsiConsoleOutput(text),
            Enrichment = new ProfileEnrichment { UseDefaultEnrichers = false },
        });
        console.Profile.Width = columns;
        console.Profile.Height = rows;
        console.Profile.Capabilities.ColorSystem = terminal.Colours;
        console.Profile.Capabilities.Unicode = terminal.IsUnicode;
        console.Write(picture);
        string[] lines = text.ToString().TrimEnd('\r', '\n').Replace("\r", string.Empty).Split('\n');
        if (lines.Length > rows)
            Array.Resize(ref lines, rows);
        return lines;
    }

    private void Write(string text)
    {
        terminal.Output.Write(text);
        terminal.Output.Flush();
    }
}
