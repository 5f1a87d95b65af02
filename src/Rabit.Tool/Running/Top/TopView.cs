using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Diagnostics.Protocol;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace Rabit.Tool.Running.Top;

/// <summary>Draws the last sample, as a screen or as lines.</summary>
internal sealed class TopView(TopSettings settings)
{
    private const int LinesAround = 3;   // header, state of the view, keys
    private static readonly Style Head = new(decoration: Decoration.Bold);
    private static readonly Style Warning = new(Color.Red, decoration: Decoration.Bold);
    private static readonly Style Dim = new(decoration: Decoration.Dim);

    private readonly TopTables _tables = new();
    private IReadOnlyList<TopTable> _last = [];
    private string _header = string.Empty;

    /// <summary>What is wrong with the connection; null while nothing is.</summary>
    public string? Fault { get; set; }

    public void Show(HelloLine hello, SampleLine sample)
    {
        _last = _tables.Make(sample);
        Fault = null;
        IEnumerable<string> reactors = sample.Reactors.Select(r => string.Create(
            CultureInfo.InvariantCulture,
            $"{PlainText.Of(r.Name)} {(r.IsStarted ? TopText.Clock(r.TimeSeconds) : "not started")}{Speed(r)}"));
        _header = string.Create(
            CultureInfo.InvariantCulture,
            $"{PlainText.Of(hello.Program)} ({hello.ProcessId})  {string.Join(", ", reactors)}{Skipped(sample)}");
    }

    /// <summary>All that is asked for, however long.</summary>
    public Rows DrawLines(int width)
        => new(new IRenderable[] { new Text(_header, Head) }.Concat(
            Tables().SelectMany(t => new IRenderable[] { Draw(t, t.Select(settings), width), Text.Empty })));

    /// <summary>A screen: what has room, from the row to which it is scrolled.</summary>
    public Rows DrawScreen(int width, int height)
    {
        List<IRenderable> lines = [Line(_header, Fault is null ? Head : Dim), StateLine()];
        int room = height - LinesAround;
        int hidden = settings.Scroll = Math.Min(settings.Scroll, Math.Max(0, Tables().Sum(RowCount) - 1));
        foreach (TopTable table in Tables())
        {
            IReadOnlyList<TopRow> rows = table.Select(settings);
            int above = Math.Min(hidden, rows.Count);
            hidden -= above;
            if ((above == rows.Count && above > 0) || room < 2)
                continue;
            TopRow[] shown = rows.Skip(above).Take(room - 1).ToArray();
            lines.Add(Draw(table, shown, width));
            room -= shown.Length + 1;
            if (room < 1)
                continue;
            lines.Add(Text.Empty);
            room--;
        }

        while (room-- > 0)
            lines.Add(Text.Empty);
        lines.Add(Line(TopKeys.Help, Dim));
        return new Rows(lines);
    }

    private IEnumerable<TopTable> Tables() => _last.Where(settings.Shows);

    private int RowCount(TopTable table) => table.Select(settings).Count;

    private static Text Line(string text, Style style) => new(text, style) { Overflow = Overflow.Crop };

    private Text StateLine()
    {
        if (Fault is not null)
            return Line(Fault, Warning);
        if (settings.IsTyping)
            return Line($"filter: {settings.Filter}_", Head);
        string filter = settings.Filter.Length == 0 ? string.Empty : $"  filter: {settings.Filter} (Esc: none)";
        string order = $"by {settings.Order.ToString().ToLowerInvariant()}{(settings.IsReversed ? ", reversed" : "")}";
        return Line(order + filter, Dim);
    }

    private static Table Draw(TopTable table, IReadOnlyList<TopRow> rows, int width)
    {
        IReadOnlyList<(int Column, int Width)> columns = TopFit.Fit(table, width);
        var drawn = new Table { Border = TableBorder.None };
        foreach ((int column, int columnWidth) in columns)
        {
            drawn.AddColumn(new TableColumn(new Text(TopFit.Cut(table.Columns[column].Head, columnWidth), Head))
            {
                Alignment = table.Columns[column].IsNumber ? Justify.Right : Justify.Left,
                Width = columnWidth,
                Padding = new Padding(0, 0, column == columns[^1].Column ? 0 : TopFit.Gap, 0),
            });
        }

        foreach (TopRow row in rows)
            drawn.AddRow(columns.Select(c => Draw(row.Cells[c.Column], c.Width)));
        return drawn;
    }

    private static Text Draw(TopCell cell, int width)
        => new(TopFit.Cut(cell.Text, width), cell.IsWarning ? Warning : null);

    private static string Speed(ReactorFigures reactor)
        => reactor.Speed is { } speed && Math.Abs(speed - 1) > 0.05
            ? string.Create(CultureInfo.InvariantCulture, $" x{speed:0.0}")
            : string.Empty;

    private static string Skipped(SampleLine sample)
        => sample.SkippedSamples == 0
            ? string.Empty
            : string.Create(CultureInfo.InvariantCulture, $"  {sample.SkippedSamples} samples skipped");
}
