using System.Collections.Generic;
using System.Linq;

namespace Rabit.Mavlink.Tests.Golden;

/// <summary>Reads golden.jsonl: 301 messages in three cases each.</summary>
internal static class GoldenVectors
{
    public static IReadOnlyList<GoldenVector> All { get; } =
        TestData.Lines("golden.jsonl").Select(line => new GoldenVector(line)).ToList();
}
