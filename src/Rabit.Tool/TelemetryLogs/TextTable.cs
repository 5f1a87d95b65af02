using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Rabit.Tool.TelemetryLogs;

/// <summary>
/// Columns of text, each as wide as its widest cell. Plain characters, so that it may go into a file or another
/// program.
/// </summary>
internal sealed class TextTable
{
    private const string Gap = "  ";

    private readonly TextWriter _output;
    private readonly bool[] _isLeft;
    private readonly List<string[]> _rows = [];

    /// <summary>Columns by their titles; those with &lt; in front are words, which begin on the left.</summary>
    public TextTable(TextWriter output, params string[] columns)
    {
        _output = output;
        _isLeft = columns.Select(column => column[0] == '<').ToArray();
        _rows.Add(columns.Select(column => column.TrimStart('<')).ToArray());
    }

    public void Add(params string[] cells) => _rows.Add(cells);

    public void Write()
    {
        int[] widths = Enumerable.Range(0, _isLeft.Length)
            .Select(column => _rows.Max(row => row[column].Length)).ToArray();
        foreach (string[] row in _rows)
            _output.WriteLine(
                string.Join(Gap, row.Select(
                    (cell, column) => _isLeft[column] ? cell.PadRight(widths[column]) : cell.PadLeft(widths[column])))
                    .TrimEnd());
    }
}
