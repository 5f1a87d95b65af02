using System.Collections.Generic;
using System.IO;
using System.Text.Json;
using Rabit.Latency.Measuring;

namespace Rabit.Latency.Reporting;

/// <summary>Writes tables for programs: every round's value, and the medians.</summary>
internal static class JsonReport
{
    public static void Write(string file, string runtime, string machine, IReadOnlyList<Table> tables)
    {
        using FileStream stream = File.Create(file);
        using var json = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true });
        json.WriteStartObject();
        json.WriteString("runtime", runtime);
        json.WriteString("machine", machine);
        json.WriteStartArray("tables");
        foreach (Table table in tables)
            Write(json, table);
        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, Table table)
    {
        json.WriteStartObject();
        json.WriteString("mode", table.Mode);
        json.WriteString("title", table.Title);
        json.WriteStartArray("rows");
        foreach (Subject row in table.Rows)
            Write(json, table, row);
        json.WriteEndArray();
        json.WriteStartArray("required");
        foreach (Requirement requirement in table.Requirements)
        {
            json.WriteStartObject();
            json.WriteString("what", requirement.What);
            WriteNumber(json, "measured", requirement.Measured);
            json.WriteNumber(requirement.IsMin ? "atLeast" : "atMost", requirement.Limit);
            json.WriteBoolean("met", requirement.IsMet);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void Write(Utf8JsonWriter json, Table table, Subject row)
    {
        json.WriteStartObject();
        json.WriteString("name", row.Name);
        json.WriteBoolean("isLimit", row == table.Limit);
        for (int i = 0; i < table.Columns.Count; i++)
        {
            json.WriteStartObject(table.Columns[i].Name);
            double median = row.Columns[i].Median;
            WriteNumber(json, "median", table.Columns[i].IsMeasured(median) ? median : double.NaN);
            if (table.RatioOf(row, i) is { } ratio)
                json.WriteNumber("timesLimit", ratio);
            json.WriteStartArray("rounds");
            foreach (double value in row.Columns[i].Values)
                json.WriteNumberValue(value);
            json.WriteEndArray();
            json.WriteEndObject();
        }

        json.WriteEndObject();
    }

    // JSON has no word for what is not a number.
    private static void WriteNumber(Utf8JsonWriter json, string name, double value)
    {
        if (double.IsNaN(value) || double.IsInfinity(value))
            json.WriteNull(name);
        else
            json.WriteNumber(name, value);
    }
}
