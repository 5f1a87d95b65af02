using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

public class MavlinkMissionServerTests
{
    private readonly MavlinkSender _station = new(255, 190);
    private readonly MavlinkSender _other = new(254, 190);
    private readonly Rules _rules = new();
    private MavlinkMissionServer _server;
    private TimeSpan _now = TimeSpan.FromSeconds(10);

    public MavlinkMissionServerTests() => _server = New(new MavlinkMissionServerOptions { MaxItems = 20 });

    [Fact]
    public void Upload_OfAFence_StoredAndReported()
    {
        Upload(_station, MavMissionType.Fence, 3);
        Assert.Equal([7, 8, 9], _server.Items(MavMissionType.Fence).ToArray().Select(item => item.X));
        Assert.True(_server.TryTakeChange(out MavlinkMissionChange change));
        Assert.Equal(
            new MavlinkMissionChange(
                MavMissionType.Fence, 3, new MavlinkAddress(255, 190), IsSigned: false,
                _server.OpaqueId(MavMissionType.Fence)),
            change);
        Assert.NotEqual(0u, change.OpaqueId);
        Assert.False(_server.TryTakeChange(out _));
        Assert.Equal(0, _server.Items(MavMissionType.Mission).Length);

        Handle(_station, new MissionRequestList { MissionType = MavMissionType.Fence });
        var count = Decode<MissionCount>(Assert.Single(Take()));
        Assert.Equal((3, change.OpaqueId), (count.Count, count.OpaqueId));
    }

    [Fact]
    public void Upload_ItemsDoNotCome_RequestedAgainAndGivenUp()
    {
        Upload(_station, MavMissionType.Fence, 2);
        Handle(_station, new MissionCount { Count = 3, MissionType = MavMissionType.Fence });
        int requests = 0;
        MavMissionResult? result = null;
        TimeSpan start = _now;
        while (_server.NextDue < TimeSpan.MaxValue)
        {
            _now = _server.NextDue > _now ? _server.NextDue : _now;
            foreach (MavlinkFrame frame in Take())
            {
                requests += frame.MessageId == MissionRequestInt.MavlinkId ? 1 : 0;
                result = frame.TryDecode(out MissionAck answer) ? answer.Type : result;
            }
        }

        Assert.Equal((20, MavMissionResult.OperationCancelled), (requests, result));
        Assert.Equal(5, (_now - start).TotalSeconds);
        Assert.Equal((2, 1), (_server.Items(MavMissionType.Fence).Length, _server.Aborts));
    }

    [Fact]
    public void Upload_TwoStationsAtOnce_TheSecondIsDenied()
    {
        Handle(_station, new MissionCount { Count = 2, MissionType = MavMissionType.Fence });
        Take();
        Handle(_other, new MissionCount { Count = 1, MissionType = MavMissionType.Rally });
        Handle(_other, new MissionClearAll { MissionType = MavMissionType.Fence });
        MissionAck[] answers = Take().Where(frame => frame.MessageId == MissionAck.MavlinkId)
            .Select(frame => Decode<MissionAck>(frame)).ToArray();
        Assert.Equal([MavMissionResult.Denied, MavMissionResult.Denied], answers.Select(answer => answer.Type));
        Assert.All(answers, answer => Assert.Equal(254, answer.TargetSystem));

        // What the second one sends all the same does not get in.
        Handle(_other, new MissionItemInt { Seq = 0, X = 99, MissionType = MavMissionType.Fence });
        Item(_station, MavMissionType.Fence, 0);
        Item(_station, MavMissionType.Fence, 1);
        Assert.Equal([7, 8], _server.Items(MavMissionType.Fence).ToArray().Select(item => item.X));
        Take();
        Upload(_other, MavMissionType.Fence, 1);
        Assert.Equal(1, _server.Items(MavMissionType.Fence).Length);
    }

    [Fact]
    public void Upload_CopiesAndWrongNumbers_AreNotStored()
    {
        Handle(_station, new MissionCount { Count = 3, MissionType = MavMissionType.Mission });
        Item(_station, MavMissionType.Mission, 0);
        Item(_station, MavMissionType.Mission, 0);
        Item(_station, MavMissionType.Mission, 2);
        Assert.Equal(2, _server.StrayItems);
        Assert.Equal(1, Decode<MissionRequestInt>(Take().Last()).Seq);
        Item(_station, MavMissionType.Mission, 1);
        Item(_station, MavMissionType.Mission, 2);
        Assert.Equal(MavMissionResult.Accepted, Decode<MissionAck>(Assert.Single(Take())).Type);

        // The acknowledgement was lost.
        Item(_station, MavMissionType.Mission, 2);
        Assert.Equal(MavMissionResult.Accepted, Decode<MissionAck>(Assert.Single(Take())).Type);
        Assert.Equal([7, 8, 9], _server.Items(MavMissionType.Mission).ToArray().Select(item => item.X));
    }

    [Theory]
    [InlineData(MavMissionResult.Accepted, 2)]
    [InlineData(MavMissionResult.Invalid, 0)]
    public void Upload_DecidedLater_IsKeptAliveAndThenAnswered(MavMissionResult decision, int stored)
    {
        _server = New(new MavlinkMissionServerOptions { DecidesLater = true });
        Handle(_station, new MissionCount { Count = 2, MissionType = MavMissionType.Fence });
        Item(_station, MavMissionType.Fence, 0);
        Item(_station, MavMissionType.Fence, 1);
        Assert.True(_server.IsDecisionAwaited);
        Assert.Equal([7, 8], _server.AwaitedItems.ToArray().Select(item => item.X));
        Take();
        for (int i = 0; i < 20; i++)
        {
            _now += TimeSpan.FromSeconds(1);
            Assert.Equal(1, Decode<MissionRequestInt>(Assert.Single(Take())).Seq);
            Item(_station, MavMissionType.Fence, 1);
        }

        Handle(_other, new MissionCount { Count = 1, MissionType = MavMissionType.Fence });
        Assert.Equal(MavMissionResult.Denied, Decode<MissionAck>(Assert.Single(Take())).Type);
        Assert.Equal(0, _server.Items(MavMissionType.Fence).Length);
        Assert.True(_server.Decide(decision, _now));
        Assert.Equal(decision, Decode<MissionAck>(Assert.Single(Take())).Type);
        Assert.Equal(stored, _server.Items(MavMissionType.Fence).Length);
        Assert.Equal(stored > 0, _server.TryTakeChange(out _));
        Assert.False(_server.Decide(decision, _now));
        Assert.Equal(TimeSpan.MaxValue, _server.NextDue);
    }

    [Fact]
    public void Upload_GivenUpBeforeTheDecision_IsNotStored()
    {
        _server = New(new MavlinkMissionServerOptions { DecidesLater = true });
        Handle(_station, new MissionCount { Count = 1, MissionType = MavMissionType.Fence });
        Item(_station, MavMissionType.Fence, 0);
        Handle(
            _station,
            new MissionAck { Type = MavMissionResult.OperationCancelled, MissionType = MavMissionType.Fence });
        Assert.False(_server.IsDecisionAwaited);
        Assert.False(_server.Decide(MavMissionResult.Accepted, _now));
        Assert.Equal((0, 1), (_server.Items(MavMissionType.Fence).Length, _server.Aborts));
    }

    [Fact]
    public void Upload_BegunAgainBySameStation_StartsOver()
    {
        Handle(_station, new MissionCount { Count = 2, MissionType = MavMissionType.Fence });
        Handle(_station, new MissionItemInt { Seq = 0, X = 55, MissionType = MavMissionType.Fence });
        Upload(_station, MavMissionType.Fence, 2);
        Assert.Equal([7, 8], _server.Items(MavMissionType.Fence).ToArray().Select(item => item.X));
        Assert.Equal(1, _server.Aborts);
    }

    [Fact]
    public void Upload_CancelledByTheStation_LeavesWhatWasThere()
    {
        Upload(_station, MavMissionType.Fence, 2);
        Handle(_station, new MissionCount { Count = 5, MissionType = MavMissionType.Fence });
        Item(_station, MavMissionType.Fence, 0);
        Handle(
            _station,
            new MissionAck { Type = MavMissionResult.OperationCancelled, MissionType = MavMissionType.Fence });
        Assert.False(_server.IsUploading);
        Take();
        Assert.Equal(TimeSpan.MaxValue, _server.NextDue);
        Assert.Equal(2, _server.Items(MavMissionType.Fence).Length);
    }

    [Theory]
    [InlineData(MavMissionType.Fence, 21, MavMissionResult.NoSpace)]
    [InlineData(MavMissionType.Rally, 1, MavMissionResult.Unsupported)]
    [InlineData(MavMissionType.All, 1, MavMissionResult.Unsupported)]
    [InlineData((MavMissionType)77, 1, MavMissionResult.Unsupported)]
    [InlineData(MavMissionType.Mission, 13, MavMissionResult.Denied)]
    public void Upload_NotTaken_AnsweredByTheReason(MavMissionType type, int count, MavMissionResult expected)
    {
        _server = New(new MavlinkMissionServerOptions { MaxItems = 20, HasRally = false });
        Handle(_station, new MissionCount { Count = (ushort)count, MissionType = type });
        var answer = Decode<MissionAck>(Assert.Single(Take()));
        Assert.Equal((expected, type), (answer.Type, answer.MissionType));
        Assert.Equal(1, _server.Refusals);
        Assert.False(_server.IsUploading);
    }

    [Fact]
    public void Upload_BadItemOrBadWhole_RefusedAndNothingChanged()
    {
        Upload(_station, MavMissionType.Fence, 2);
        Handle(_station, new MissionCount { Count = 2, MissionType = MavMissionType.Fence });
        Handle(_station, new MissionItemInt { Seq = 0, X = -1, MissionType = MavMissionType.Fence });
        Assert.Equal(MavMissionResult.InvalidParam5X, Decode<MissionAck>(Take().Last()).Type);
        Assert.False(_server.IsUploading);

        _rules.Whole = MavMissionResult.Invalid;
        Handle(_station, new MissionCount { Count = 1, MissionType = MavMissionType.Fence });
        Item(_station, MavMissionType.Fence, 0);
        Assert.Equal(MavMissionResult.Invalid, Decode<MissionAck>(Take().Last()).Type);
        Assert.Equal(2, _server.Items(MavMissionType.Fence).Length);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Clear_ByMessageOrByCountZero_Empties(bool isByCount)
    {
        Upload(_station, MavMissionType.Fence, 2);
        Upload(_station, MavMissionType.Rally, 2);
        if (isByCount)
            Handle(_station, new MissionCount { MissionType = MavMissionType.Fence });
        else
            Handle(_station, new MissionClearAll { MissionType = MavMissionType.Fence });
        Assert.Equal(MavMissionResult.Accepted, Decode<MissionAck>(Assert.Single(Take())).Type);
        Assert.Equal(0, _server.Items(MavMissionType.Fence).Length);
        Assert.Equal((0u, 2), (_server.OpaqueId(MavMissionType.Fence), _server.Items(MavMissionType.Rally).Length));
        Handle(_station, new MissionClearAll { MissionType = MavMissionType.All });
        Assert.Equal(0, _server.Items(MavMissionType.Rally).Length);
    }

    [Fact]
    public void Download_ChangedMeanwhile_IsCancelled()
    {
        Upload(_station, MavMissionType.Fence, 3);
        Handle(_other, new MissionRequestList { MissionType = MavMissionType.Fence });
        Handle(_other, new MissionRequestInt { Seq = 0, MissionType = MavMissionType.Fence });
        Assert.Equal(7, Decode<MissionItemInt>(Take().Last()).X);
        Upload(_station, MavMissionType.Fence, 3);
        Handle(_other, new MissionRequestInt { Seq = 1, MissionType = MavMissionType.Fence });
        Assert.Equal(MavMissionResult.OperationCancelled, Decode<MissionAck>(Assert.Single(Take())).Type);
        Handle(_other, new MissionRequestList { MissionType = MavMissionType.Fence });
        Handle(_other, new MissionRequest { Seq = 2, MissionType = MavMissionType.Fence });
        Assert.Equal(9, Decode<MissionItemInt>(Take().Last()).X);
        Handle(_other, new MissionRequestInt { Seq = 3, MissionType = MavMissionType.Fence });
        Assert.Equal(MavMissionResult.InvalidSequence, Decode<MissionAck>(Assert.Single(Take())).Type);
    }

    [Fact]
    public void SetCurrent_ByMessageAndFromThisSide_IsReported()
    {
        Upload(_station, MavMissionType.Mission, 3);
        Handle(_station, new MissionSetCurrent { Seq = 2 });
        _server.State = MissionState.Active;
        var current = Decode<MissionCurrent>(Assert.Single(Take()));
        Assert.Equal((2, 3, MissionState.Active), (current.Seq, current.Total, current.MissionState));
        Assert.Equal(_server.OpaqueId(MavMissionType.Mission), current.MissionId);
        Assert.True(_server.TryTakeSetCurrent(out int sequence));
        Assert.Equal(2, sequence);
        Assert.False(_server.TryTakeSetCurrent(out _));
        Handle(_station, new MissionSetCurrent { Seq = 3 });
        Assert.Equal(MavMissionResult.InvalidSequence, Decode<MissionAck>(Assert.Single(Take())).Type);
        Assert.False(_server.TrySetCurrent(3));

        _server.ReportReached(2);
        Assert.Equal(2, Decode<MissionItemReached>(Assert.Single(Take())).Seq);
        Upload(_station, MavMissionType.Mission, 1);
        Assert.Equal(0, _server.Current);
    }

    [Fact]
    public void Handle_PartialTransfers_AreUnsupported()
    {
        Handle(_station, new MissionRequestPartialList());
        Handle(_station, new MissionWritePartialList());
        Assert.All(Take(), frame => Assert.Equal(MavMissionResult.Unsupported, Decode<MissionAck>(frame).Type));
        Assert.Equal(2, _server.Refusals);
    }

    [Fact]
    public void Handle_ForOthers_IsIgnored()
    {
        foreach (int address in new[] { 0x0101, 0x0100, 0x02BF })
        {
            var list = new MissionRequestList
            {
                TargetSystem = (byte)(address >> 8),
                TargetComponent = (byte)address,
            };
            _server.Handle(_station.Create(list), _now);
        }

        Assert.Empty(Take());
    }

    [Fact]
    public void Handle_RandomFrames_NeverStoresHalfOfAnUpload()
    {
        var random = new ProtocolRandom(7);
        for (int i = 0; i < 20_000; i++)
        {
            MavlinkSender from = random.Below(2) == 0 ? _station : _other;
            var type = (MavMissionType)random.Below(4);
            ushort number = (ushort)random.Below(4);
            switch (random.Below(8))
            {
                case 0: Handle(from, new MissionCount { Count = number, MissionType = type }); break;
                case 1: Handle(from, new MissionClearAll { MissionType = type }); break;
                case 2: Handle(from, new MissionRequestInt { Seq = number, MissionType = type }); break;
                case 3: Handle(from, new MissionSetCurrent { Seq = number }); break;
                case 4: Handle(from, new MissionAck { Type = (MavMissionResult)number, MissionType = type }); break;
                case 5: Handle(from, new MissionRequestList { MissionType = type }); break;
                default:
                    var item = new MissionItemInt
                    {
                        Seq = number,
                        MissionType = type,
                        X = from.SystemId
                    };
                    Handle(from, item);
                    break;
            }

            _now += TimeSpan.FromMilliseconds(random.Below(200));
            Take();

            // Items carry their sender: those that are stored are of one.
            for (int stored = 0; stored < 3; stored++)
                Assert.True(
                    _server.Items((MavMissionType)stored).ToArray().Select(item => item.X).Distinct().Count() <= 1,
                    $"step {i}");
        }
    }

    [Fact]
    public void BadInput_Throws()
    {
        Assert.Throws<ArgumentNullException>(() => new MavlinkMissionServer(null!));
        Assert.Throws<ArgumentOutOfRangeException>(() => New(new MavlinkMissionServerOptions { MaxItems = 65536 }));
        Assert.Throws<ArgumentOutOfRangeException>(() => New(new MavlinkMissionServerOptions { Capacity = 0 }));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => New(new MavlinkMissionServerOptions { RequestInterval = TimeSpan.Zero }));
        Assert.Throws<ArgumentOutOfRangeException>(() => _server.Items(MavMissionType.All).Length);
        Assert.Throws<ArgumentException>(() => _server.Store(MavMissionType.Rally, new MissionItemInt[21]));
    }

    private MavlinkMissionServer New(MavlinkMissionServerOptions options)
        => new(new MavlinkSender(1, 191), _rules, options);

    private void Upload(MavlinkSender from, MavMissionType type, int count)
    {
        Handle(from, new MissionCount { Count = (ushort)count, MissionType = type });
        for (int i = 0; i < count; i++)
        {
            Assert.Equal(i, Decode<MissionRequestInt>(Assert.Single(Take())).Seq);
            Item(from, type, i);
        }

        Assert.Equal(MavMissionResult.Accepted, Decode<MissionAck>(Assert.Single(Take())).Type);
    }

    private void Item(MavlinkSender from, MavMissionType type, int sequence)
        => Handle(from, new MissionItemInt { Seq = (ushort)sequence, X = 7 + sequence, MissionType = type });

    private void Handle<T>(MavlinkSender from, T message)
        where T : struct, IMavlinkMessage
    {
        // Every mission message has its target under these names.
        object boxed = message;
        typeof(T).GetProperty("TargetSystem")!.SetValue(boxed, (byte)1);
        typeof(T).GetProperty("TargetComponent")!.SetValue(boxed, (byte)191);
        _server.Handle(from.Create((T)boxed), _now);
    }

    private static T Decode<T>(MavlinkFrame frame)
        where T : struct, IMavlinkMessage
    {
        Assert.True(frame.TryDecode(out T message), $"{frame} is no {typeof(T).Name}");
        return message;
    }

    private List<MavlinkFrame> Take()
    {
        var frames = new List<MavlinkFrame>();
        while (_server.TryTakeFrame(_now, out MavlinkFrame frame))
            frames.Add(frame);
        return frames;
    }

    private sealed class Rules : IMavlinkMissionRules
    {
        public MavMissionResult Whole { get; set; }

        public MavMissionResult CheckTransfer(MavMissionType type, int count, MavlinkAddress source, bool isSigned)
            => count == 13 ? MavMissionResult.Denied : MavMissionResult.Accepted;

        public MavMissionResult CheckItem(in MissionItemInt item)
            => item.X < 0 ? MavMissionResult.InvalidParam5X : MavMissionResult.Accepted;

        public MavMissionResult CheckItems(MavMissionType type, ReadOnlySpan<MissionItemInt> items) => Whole;
    }
}
