using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

public class MavlinkStatusTextTests
{
    private static readonly MavlinkSender Vehicle = new(1, 1);
    private static readonly MavlinkSender Camera = new(1, 100);
    private readonly MavlinkStatusTextReceiver _receiver = new();
    private readonly MavlinkStatusTextSplitter _splitter = new(maxChunks: 32);
    private TimeSpan _now = TimeSpan.FromSeconds(10);

    public static TheoryData<string> Texts { get; } =
    [
        "", "short", new string('a', 49), new string('a', 50), new string('a', 51), new string('b', 99),
        new string('b', 100), new string('b', 101), new string('\u20AC', 33),
        string.Concat(Enumerable.Repeat("Gr\u00FC\u00DFe \U0001F681 ", 20)),
    ];

    [Theory]
    [MemberData(nameof(Texts))]
    public void SplitAndReceive_AnyOrder_TheSameText(string text)
    {
        for (ulong seed = 1; seed <= 10; seed++)
        {
            var random = new ProtocolRandom(seed);
            List<Statustext> chunks = Split(text);
            while (chunks.Count > 0)
            {
                int next = random.Below(chunks.Count);
                Handle(Vehicle, chunks[next]);
                chunks.RemoveAt(next);
                Assert.Equal(chunks.Count == 0, _receiver.NextDue == TimeSpan.Zero);
            }

            Assert.Equal([(text, true)], Take());
            Assert.Equal(TimeSpan.MaxValue, _receiver.NextDue);
            _now += TimeSpan.FromSeconds(1);
        }
    }

    [Theory]
    [InlineData(50, 1)]
    [InlineData(51, 2)]
    [InlineData(99, 2)]
    [InlineData(100, 3)]
    public void Split_LengthOfText_EndsWithAShorterChunkOfOneId(int length, int count)
    {
        List<Statustext> chunks = Split(new string('x', length));
        Assert.Equal(count, chunks.Count);
        Assert.All(chunks, chunk => Assert.Equal(count > 1 ? 1 : 0, chunk.Id));
        Assert.Equal(Enumerable.Range(0, count), chunks.Select(chunk => (int)chunk.ChunkSeq));
        Assert.True(count == 1 || chunks[count - 1].Text.Length < 50);
        Assert.Equal(count > 1 ? 2 : 0, Split(new string('y', length))[0].Id);
    }

    [Fact]
    public void Split_TooLong_IsCutBetweenCharacters()
    {
        var splitter = new MavlinkStatusTextSplitter(maxChunks: 2);
        splitter.Start(MavSeverity.Info, new string('\u20AC', 34));
        Assert.True(splitter.IsCut);
        while (splitter.TryNext(out Statustext chunk))
            Handle(Vehicle, chunk);
        Assert.Equal([(new string('\u20AC', 33), true)], Take());
        var one = new MavlinkStatusTextSplitter(maxChunks: 1);
        one.Start(MavSeverity.Info, new string('x', 60));
        Assert.True(one.IsCut && one.TryNext(out Statustext only) && only.Text.Length == 50 && !one.TryNext(out _));
        Assert.Throws<ArgumentOutOfRangeException>(() => new MavlinkStatusTextSplitter(0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new MavlinkStatusTextSplitter(257));
    }

    [Fact]
    public void Split_ControlCharactersAndHalfPairs_AreQuestionMarks()
    {
        Handle(Vehicle, Split("a\0b\nc\uD83Dd\uDE81").Single());
        Assert.Equal([("a?b?c?d?", true)], Take());
    }

    [Theory]
    [InlineData(0, "\u2026BBBBBCCCCC")]
    [InlineData(1, "AAAAA\u2026CCCCC")]
    [InlineData(2, "AAAAABBBBB\u2026")]
    public void Handle_ChunkIsLost_TextWithAGapAfterASecond(int lost, string shown)
    {
        List<Statustext> chunks = Split(new string('A', 50) + new string('B', 50) + new string('C', 20));
        chunks.RemoveAt(lost);
        foreach (Statustext chunk in chunks)
            Handle(Vehicle, chunk);
        Assert.Empty(Take());
        Assert.Equal(_now + TimeSpan.FromSeconds(1), _receiver.NextDue);
        _now += TimeSpan.FromSeconds(0.99);
        Assert.Empty(Take());
        _now += TimeSpan.FromSeconds(0.01);
        (string text, bool isComplete) = Take().Single();
        Assert.False(isComplete);
        Assert.Equal(1, _receiver.Incomplete);
        string pattern = text.Replace(new string('A', 50), "AAAAA").Replace(new string('B', 50), "BBBBB")
            .Replace(new string('C', 20), "CCCCC");
        Assert.Equal(shown, pattern);
    }

    // U+20AC is three bytes: of 50 bytes, the last two begin one that goes on in the next chunk.
    [Fact]
    public void Handle_GapInACharacter_HalvesOfItAreLeftOut()
    {
        string text = new('\u20AC', 60);
        List<Statustext> chunks = Split(text);
        Assert.Equal(4, chunks.Count);
        chunks.RemoveAt(1);
        foreach (Statustext chunk in chunks)
            Handle(Vehicle, chunk);
        _now += TimeSpan.FromSeconds(1);
        Assert.Equal([(new string('\u20AC', 16) + "\u2026" + new string('\u20AC', 26), false)], Take());
    }

    [Fact]
    public void Handle_SeveralSendersAndTextsInTurn_EachIsPutTogether()
    {
        var other = new MavlinkStatusTextSplitter();
        List<Statustext> first = Split(new string('1', 120));
        List<Statustext> second = Split(new string('2', 120));
        List<Statustext> ofCamera = Split(other, new string('3', 120));
        Assert.Equal(first[0].Id, ofCamera[0].Id);
        for (int i = 0; i < first.Count; i++)
        {
            Handle(Vehicle, first[i]);
            Handle(Camera, ofCamera[i]);
            Handle(Vehicle, second[i]);
            Handle(new MavlinkSender(2, 1), new Statustext { Text = new Text50("alone") });
        }

        Assert.Equal(
            ["alone", "alone", new string('1', 120), new string('3', 120), new string('2', 120), "alone"],
            Take().Select(t => t.Text));
    }

    [Fact]
    public void Handle_CopiesOfChunks_AreOneText()
    {
        List<Statustext> chunks = Split(new string('x', 120));
        foreach (Statustext chunk in chunks)
        {
            Handle(Vehicle, chunk);
            Handle(Vehicle, chunk);
        }

        Handle(Vehicle, chunks[0]);
        _now += TimeSpan.FromSeconds(5);
        Assert.Equal([(new string('x', 120), true)], Take());
        Assert.Equal(4, _receiver.Repeats);
    }

    // A sender that has started again counts from 1 again.
    [Fact]
    public void Handle_IdIsUsedAgain_TheTextBeforeIsEnded()
    {
        List<Statustext> before = Split(new string('a', 120));
        Handle(Vehicle, before[0]);
        Handle(Vehicle, before[1]);
        foreach (Statustext chunk in Split(new MavlinkStatusTextSplitter(), new string('b', 60)))
            Handle(Vehicle, chunk);
        Assert.Equal([(new string('a', 100) + "\u2026", false), (new string('b', 60), true)], Take());
    }

    [Fact]
    public void Handle_NineTextsAtATime_TheOldestIsEnded()
    {
        for (int i = 0; i < 9; i++)
        {
            Handle(Vehicle, Split(new string((char)('a' + i), 60))[0]);
            _now += TimeSpan.FromMilliseconds(1);
        }

        Assert.Equal([(new string('a', 50) + "\u2026", false)], Take());
    }

    [Fact]
    public void Handle_ChunkThatCannotBe_IsRefusedAndCounted()
    {
        List<Statustext> chunks = Split(new string('x', 70));
        Handle(Vehicle, chunks[1]);
        Statustext behind = chunks[0];
        behind.ChunkSeq = 2;
        Handle(Vehicle, behind);
        behind.ChunkSeq = 32;
        Handle(Vehicle, behind);
        behind.ChunkSeq = 255;
        Handle(Vehicle, behind);
        Assert.Equal(3, _receiver.Refused);
        Handle(Vehicle, chunks[0]);
        Assert.Equal([(new string('x', 70), true)], Take());
    }

    // The extensions are no part of MAVLink 1: each message is a text.
    [Fact]
    public void Handle_Mavlink1_EachIsAText()
    {
        foreach (Statustext chunk in Split(new string('x', 70)))
            _receiver.Handle(MavlinkFrame.Create(chunk, 1, 1, 0, MavlinkVersion.V1), _now);
        Assert.Equal([(new string('x', 50), true), (new string('x', 20), true)], Take());
    }

    [Fact]
    public void Handle_RandomChunks_NoExceptionAndEveryTextIsBounded()
    {
        const int Chunks = 20_000;
        var random = new ProtocolRandom(7);
        var bytes = new byte[50];
        int texts = 0;
        for (int i = 0; i < Chunks; i++)
        {
            for (int b = 0; b < bytes.Length; b++)
                bytes[b] = (byte)(random.Below(200) == 0 ? 0 : 1 + random.Below(255));
            Handle(random.Below(2) == 0 ? Vehicle : Camera, new Statustext
            {
                Severity = (MavSeverity)random.Below(256),
                Text = new Text50(bytes),
                Id = (ushort)random.Below(12),
                ChunkSeq = (byte)random.Below(random.Below(4) == 0 ? 256 : 6),
            });
            _now += TimeSpan.FromMilliseconds(random.Below(100));
            foreach ((string text, _) in Take())
            {
                texts++;
                Assert.InRange(text.Length, 0, 1633);
            }
        }

        Assert.InRange(texts, 1, Chunks);
        Assert.Equal(0, _receiver.Dropped);
    }

    [Fact]
    public void Handle_NoneIsTaken_OldestAreDroppedAndCounted()
    {
        for (int i = 0; i < 40; i++)
            Handle(Vehicle, new Statustext { Text = new Text50("text " + i) });
        List<(string Text, bool)> taken = Take();
        Assert.Equal((32, 8L, "text 8"), (taken.Count, _receiver.Dropped, taken[0].Text));
    }

    [Fact]
    public void Handle_ChunksWithoutATextAtTheEnd_AllocateNothing()
    {
        string text = new('x', 120);
        _splitter.Start(MavSeverity.Info, text);
        Action work = () =>
        {
            _splitter.Start(MavSeverity.Info, text);
            _splitter.TryNext(out Statustext first);
            _splitter.TryNext(out Statustext second);
            Handle(Vehicle, first);
            Handle(Vehicle, second);
            Handle(Vehicle, first);
        };
        work();
        Assert.Equal(0, Allocated.By(work, () =>
        {
            _now += TimeSpan.FromSeconds(2);
            Take();
        }));
    }

    private void Handle(MavlinkSender sender, Statustext chunk) => _receiver.Handle(sender.Create(chunk), _now);

    private List<Statustext> Split(string text) => Split(_splitter, text);

    private static List<Statustext> Split(MavlinkStatusTextSplitter splitter, string text)
    {
        var chunks = new List<Statustext>();
        splitter.Start(MavSeverity.Warning, text);
        while (splitter.TryNext(out Statustext chunk))
            chunks.Add(chunk);
        return chunks;
    }

    private List<(string Text, bool IsComplete)> Take()
    {
        var taken = new List<(string, bool)>();
        while (_receiver.TryTake(_now, out MavlinkStatusText text))
            taken.Add((text.Text, text.IsComplete));
        return taken;
    }
}
