using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Latency.Measuring;

namespace Rabit.Latency.Reporting;

/// <summary>Writes tables into a document, between the two marks of this runtime: what was there is replaced.</summary>
internal static class MarkdownReport
{
    public static void WriteInto(string file, string runtime, string machine, IReadOnlyList<Table> tables)
    {
        string begin = $"<!-- figures of {runtime} -->";
        string end = $"<!-- end of the figures of {runtime} -->";
        string text = File.ReadAllText(file);
        int from = text.IndexOf(begin, StringComparison.Ordinal);
        int to = text.IndexOf(end, StringComparison.Ordinal);
        if (from < 0 || to < from)
            throw new InvalidOperationException(
                $"{file} has no place for the figures: '{begin}' and '{end}', each on a line of its own.");

        var written = new StringBuilder(begin).Append("\n\nMeasured on ").Append(machine).Append('.').Append('\n');
        foreach (Table table in tables)
            Append(written, table);
        written.Append('\n');
        File.WriteAllText(file, text.Substring(0, from) + written + text.Substring(to));
    }

    private static void Append(StringBuilder text, Table table)
    {
        text.Append('\n').Append("**").Append(table.Mode).Append("**: ").Append(table.Title).Append("\n\n|");
        foreach (Column column in table.Columns)
            text.Append(" | ").Append(column.Name);
        text.Append(" |\n|---|").Append(string.Concat(Enumerable.Repeat("---:|", table.Columns.Count))).Append('\n');
        foreach (Subject row in table.Rows)
            AppendRow(text, table, row);
        if (table.Requirements.Count == 0)
            return;

        text.Append("\n| required of | measured | required | met |\n|---|---:|---:|---|\n");
        foreach (Requirement requirement in table.Requirements)
        {
            text.Append("| ").Append(requirement.What)
                .Append(" | ").Append(TextReport.Figure(requirement.Measured, "0.00#")).Append(requirement.Unit)
                .Append(" | ").Append(TextReport.Limit(requirement).Replace("<=", "≤").Replace(">=", "≥"))
                .Append(" | ").Append(requirement.IsMet ? "yes" : "**no**").Append(" |\n");
        }
    }

    private static void AppendRow(StringBuilder text, Table table, Subject row)
    {
        text.Append("| ").Append(row.Name).Append(row == table.Limit ? $" ({table.LimitName})" : string.Empty);
        for (int i = 0; i < table.Columns.Count; i++)
        {
            text.Append(" | ").Append(table.Columns[i].Text(row.Columns[i].Median));
            if (row != table.Limit && table.RatioOf(row, i) is { } ratio)
                text.Append(" (×").Append(TextReport.Figure(ratio, "0.00")).Append(')');
        }

        text.Append(" |\n");
    }
}
