using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;

namespace Rabit.Mavlink.Tests.Golden;

/// <summary>Reads golden.jsonl: 301 messages in three cases each.</summary>
internal static class GoldenVectors
{
    public static IReadOnlyList<GoldenVector> All { get; } =
        File.ReadLines(Path.Combine(AppContext.BaseDirectory, "data", "mavlink", "golden.jsonl")).Select(Parse).ToList();

    private static GoldenVector Parse(string line)
    {
        using var document = JsonDocument.Parse(line);
        return new GoldenVector(document.RootElement.Clone());
    }
}
