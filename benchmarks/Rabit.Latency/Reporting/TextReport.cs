using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Latency.Measuring;

namespace Rabit.Latency.Reporting;

/// <summary>Writes tables for people.</summary>
internal static class TextReport
{
    private const int NameWidth = 42;
    private const int FigureWidth = 16;
    private const int RatioWidth = 9;

    public static void Write(TextWriter output, Table table)
    {
        output.WriteLine();
        output.WriteLine($"{table.Mode}: {table.Title}");
        output.Write(new string(' ', NameWidth));
        foreach (Column column in table.Columns)
        {
            output.Write(column.Name.PadLeft(FigureWidth));
            if (table.Limit is not null && column.HasRatio)
                output.Write(("x " + table.LimitName).PadLeft(RatioWidth));
        }

        output.WriteLine();
        foreach (Subject row in table.Rows)
            WriteRow(output, table, row);
        if (table.Requirements.Count > 0)
            WriteRequirements(output, table.Requirements);
    }

    public static string Figure(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);

    public static string Limit(Requirement requirement)
        => $"{(requirement.IsMin ? ">=" : "<=")} {Figure(requirement.Limit, "0.###")}{requirement.Unit}";

    private static void WriteRow(TextWriter output, Table table, Subject row)
    {
        string name = "  " + row.Name + (row == table.Limit ? $" ({table.LimitName})" : string.Empty);
        output.Write(name.PadRight(NameWidth));
        for (int i = 0; i < table.Columns.Count; i++)
        {
            output.Write(table.Columns[i].Text(row.Columns[i].Median).PadLeft(FigureWidth));
            if (table.Limit is not null && table.Columns[i].HasRatio)
                output.Write(
                    (table.RatioOf(row, i) is { } ratio ? Figure(ratio, "0.00") : string.Empty).PadLeft(RatioWidth));
        }

        output.WriteLine();
    }

    private static void WriteRequirements(TextWriter output, IReadOnlyList<Requirement> requirements)
    {
        int width = Math.Max(NameWidth, requirements.Max(r => r.What.Length) + 4);
        output.WriteLine(
            "  required".PadRight(width) + "measured".PadLeft(FigureWidth) + "required".PadLeft(FigureWidth) + "  met");
        foreach (Requirement requirement in requirements)
        {
            output.WriteLine(
                ("  " + requirement.What).PadRight(width)
                + (Figure(requirement.Measured, "0.00#") + requirement.Unit).PadLeft(FigureWidth)
                + Limit(requirement).PadLeft(FigureWidth)
                + (requirement.IsMet ? "  yes" : "  NO"));
        }
    }
}
