using System;
using System.Collections;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using Rabit.Diagnostics.Values;
using Xunit;

namespace Rabit.Diagnostics.Tests;

/// <summary>Values of any type as JSON: what cannot be written is named in its place.</summary>
public sealed class ValueWriterTests
{
    private enum Gear
    {
        First = 1,
    }

    [Fact]
    public void Write_SimpleValues_AreNumbersWordsAndTexts()
    {
        Assert.Equal("null", Json(null));
        Assert.Equal("7", Json((byte)7));
        Assert.Equal("-7", Json(-7L));
        Assert.Equal("18446744073709551615", Json(ulong.MaxValue));
        Assert.Equal("0.1", Json(0.1f));
        Assert.Equal("\"NaN\"", Json(double.NaN));
        Assert.Equal("\"-Infinity\"", Json(float.NegativeInfinity));
        Assert.Equal("true", Json(true));
        Assert.Equal("\"First\"", Json(Gear.First));
        Assert.Equal("\"00:00:01.5000000\"", Json(TimeSpan.FromSeconds(1.5)));
        Assert.Equal("\"2026-01-02T03:04:05.0000000+00:00\"", Json(new DateTimeOffset(2026, 1, 2, 3, 4, 5, default)));
        Assert.Equal("\"ü \\u001B\\u0085\"", Json("ü \u001b\u0085"));
        Assert.Equal("\"(no value: Action)\"", Json((Action)(() => { })));
    }

    [Fact]
    public void Write_Structs_HaveFieldsAndPropertiesButNotWhatIsComputedOfTheirOwnType()
        => Assert.Equal(
            """{"east":1,"pair":{"item1":2,"item2":"b"},"maybe":null,"length":1}""",
            Json(new Vector { East = 1, Pair = (2, "b") }));

    [Fact]
    public void Write_Collections_AreArraysAndUnsetOnesNull()
    {
        Assert.Equal("[1,2]", Json(new[] { 1, 2 }));
        Assert.Equal("[1,2]", Json(ImmutableArray.Create(1, 2)));
        Assert.Equal("null", Json(default(ImmutableArray<int>)));
        Assert.Equal("""[{"key":"a","value":1}]""", Json(new Dictionary<string, int> { ["a"] = 1 }));
        Assert.Equal("""["left out here"]""", Json(new List<object> { "left out here" }));
    }

    [Fact]
    public void Write_CyclesAndThrowingMembers_AreNamed()
    {
        var node = new Node { Name = "n" };
        node.Next = node;
        Assert.Equal(
            "{\"name\":\"n\",\"next\":\"(cycle: Node again)\",\"bad\":\"(threw FormatException)\","
                + "\"items\":[\"(threw NotSupportedException)\"]}",
            Json(node));
    }

    [Fact]
    public void Write_MoreThanTheLimits_SaysWhatIsLeftOut()
    {
        var limits = new ValueLimits { MaxDepth = 2, MaxItems = 3, MaxTextLength = 4, MaxParts = 100 };
        Assert.Equal("[1,1,1,\"(left out: 7 more)\"]", Json(Enumerable.Repeat(1, 10).ToArray(), limits));
        Assert.Equal("[0,0,0,\"(left out: more)\"]", Json(new Endless(), limits));
        Assert.Equal("\"abcd(left out: 2 characters)\"", Json("abcdef", limits));
        Assert.Equal("[[\"(left out: Int32[])\"]]", Json(new[] { new[] { new[] { 1 } } }, limits));
    }

    [Fact]
    public void Write_ABranchingTree_EndsAtTheNumberOfParts()
    {
        string json = Json(new Tree(), new ValueLimits { MaxParts = 1000 });

        Assert.InRange(json.Length, 1000, 100_000);
        Assert.Contains("(left out: Tree)", json);
    }

    private static string Json(object? value, ValueLimits? limits = null)
    {
        using var stream = new MemoryStream();
        using (var json = new Utf8JsonWriter(
            stream, new JsonWriterOptions { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping }))
            new ValueWriter(limits).Write(json, value);
        return Encoding.UTF8.GetString(stream.ToArray());
    }

    internal struct Vector
    {
        public double East;
        public (int Number, string Text) Pair;
        public int? Maybe { get; init; }

        public readonly double Length => Math.Abs(East);

        public readonly Vector Unit => new() { East = 1 };

        public readonly ReadOnlySpan<byte> Bytes => default;

        public readonly double this[int index] => index;
    }

    internal sealed class Node
    {
        public string Name { get; set; } = string.Empty;

        public Node? Next { get; set; }

        public int Bad => throw new FormatException("bad");

        public ThrowingList Items { get; } = new();
    }

    internal sealed class ThrowingList : IReadOnlyCollection<int>
    {
        public int Count => throw new NotSupportedException();

        public IEnumerator<int> GetEnumerator() => throw new NotSupportedException();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
    }

    internal sealed class Endless : IReadOnlyCollection<int>
    {
        public int Count => int.MaxValue;

        public IEnumerator<int> GetEnumerator()
        {
            while (true)
                yield return 0;
        }

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
    }

    internal sealed class Tree
    {
        public Tree Left => new();

        public Tree Right => new();
    }
}
