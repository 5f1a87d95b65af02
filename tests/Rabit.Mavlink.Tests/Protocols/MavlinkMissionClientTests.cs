using System;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>Single transfers, frame by frame.</summary>
public class MavlinkMissionClientTests
{
    private static readonly MavlinkSender Vehicle = new(1, 1);
    private readonly MavlinkMissionClient _client = new(ScriptedVehicle.Companion(), ScriptedVehicle.Address);
    private TimeSpan _now = TimeSpan.FromSeconds(10);

    // ArduPilot answers a copy of an item so, and continues; what it has at the end is not known.
    [Fact]
    public void Upload_InvalidSequenceToACopyThenSilence_IsUnknown()
    {
        Assert.True(_client.TryStartUpload(MavMissionType.Mission, new MissionItemInt[3], _now));
        Assert.True(_client.TryTakeFrame(_now, out MavlinkFrame frame) && frame.TryDecode(out MissionCount _));
        Receive(new MissionRequestInt { Seq = 0, TargetSystem = 1, TargetComponent = 191 });
        Assert.True(_client.TryTakeFrame(_now, out frame) && frame.TryDecode(out MissionItemInt _));
        _now = _client.NextDue;
        Assert.True(_client.TryTakeFrame(_now, out frame) && frame.TryDecode(out MissionItemInt _));
        Receive(new MissionAck { Type = MavMissionResult.InvalidSequence, TargetSystem = 1, TargetComponent = 191 });

        MavlinkMissionOutcome outcome = RunToTheEnd();

        Assert.Equal(
            (MavlinkMissionStatus.Unknown, MavMissionResult.InvalidSequence), (outcome.Status, outcome.Result));
    }

    [Fact]
    public void Download_InvalidSequenceToEveryRequest_IsRefused()
    {
        Assert.True(_client.TryStartDownload(MavMissionType.Mission, _now));
        Assert.True(_client.TryTakeFrame(_now, out _));
        Receive(new MissionCount { Count = 2, TargetSystem = 1, TargetComponent = 191 });
        Assert.True(_client.TryTakeFrame(_now, out _));
        Receive(new MissionAck { Type = MavMissionResult.InvalidSequence, TargetSystem = 1, TargetComponent = 191 });

        Assert.Equal(MavlinkMissionStatus.Refused, RunToTheEnd().Status);
    }

    [Fact]
    public void Clear_AllAtOnce_IsDone()
    {
        Assert.True(_client.TryStartClear(MavMissionType.All, _now));
        Assert.Equal((true, MavMissionType.All), TakeClearing());
        Answer(MavMissionType.All, MavMissionResult.Accepted);
        Assert.Equal((MavlinkMissionStatus.Done, 1), Outcome());
    }

    // ArduPilot.
    [Fact]
    public void Clear_AllIsNotKnown_OneTypeAfterTheOther()
    {
        Assert.True(_client.TryStartClear(MavMissionType.All, _now));
        TakeClearing();
        Answer(MavMissionType.All, MavMissionResult.Unsupported);
        foreach (MavMissionType type in new[] { MavMissionType.Mission, MavMissionType.Fence, MavMissionType.Rally })
        {
            Assert.Equal((true, type), TakeClearing());
            Answer(MavMissionType.All, MavMissionResult.Unsupported);   // a late copy
            Answer(type, MavMissionResult.Accepted);
        }

        Assert.Equal((MavlinkMissionStatus.Done, 4), Outcome());
        Assert.True(_client.TryStartClear(MavMissionType.All, _now));
    }

    [Fact]
    public void Clear_MissionIsNotClearedOtherwise_NoItemsAreSent()
    {
        Assert.True(_client.TryStartClear(MavMissionType.Mission, _now));
        TakeClearing();
        Answer(MavMissionType.Mission, MavMissionResult.Unsupported);
        Answer(MavMissionType.Mission, MavMissionResult.Unsupported);   // a copy, before it is asked again
        Assert.False(_client.TryTakeFrame(_now, out _));
        _now = _client.NextDue;
        Assert.Equal((false, MavMissionType.Mission), TakeClearing());
        Answer(MavMissionType.Mission, MavMissionResult.Accepted);
        Assert.Equal((MavlinkMissionStatus.Done, 2), Outcome());
    }

    // One that has missions only.
    [Fact]
    public void Clear_FencesAndRallyPointsAreNotKnown_IsDone()
    {
        Assert.True(_client.TryStartClear(MavMissionType.All, _now));
        int sent = 0;
        while (_client.NextDue < TimeSpan.MaxValue)
        {
            _now = _client.NextDue > _now ? _client.NextDue : _now;
            (_, MavMissionType type) = TakeClearing();
            sent++;
            Answer(
                type, type == MavMissionType.Mission ? MavMissionResult.Accepted : MavMissionResult.Unsupported);
        }

        Assert.Equal((MavlinkMissionStatus.Done, sent), Outcome());
        Assert.Equal(6, sent);
    }

    [Theory]
    [InlineData(MavMissionResult.Denied, MavlinkMissionStatus.Refused)]
    [InlineData(MavMissionResult.Unsupported, MavlinkMissionStatus.Refused)]
    [InlineData(MavMissionResult.OperationCancelled, MavlinkMissionStatus.Cancelled)]
    public void Clear_MissionIsRefused_TheOutcomeSaysSo(MavMissionResult result, MavlinkMissionStatus status)
    {
        Assert.True(_client.TryStartClear(MavMissionType.All, _now));
        while (_client.NextDue < TimeSpan.MaxValue)
        {
            _now = _client.NextDue > _now ? _client.NextDue : _now;
            (_, MavMissionType type) = TakeClearing();
            Answer(type, type is MavMissionType.Fence or MavMissionType.Rally ? MavMissionResult.Accepted : result);
        }

        Assert.True(_client.TryTakeOutcome(out MavlinkMissionOutcome outcome));
        Assert.Equal((status, result), (outcome.Status, outcome.Result));
    }

    [Fact]
    public void Clear_AllToAVehicleThatIsSilent_IsUnknownAfterTheFirstType()
    {
        Assert.True(_client.TryStartClear(MavMissionType.All, _now));
        MavlinkMissionOutcome outcome = RunToTheEnd();
        Assert.Equal(
            (MavlinkMissionStatus.Unknown, (MavMissionResult?)null, 12),
            (outcome.Status, outcome.Result, outcome.Sent));
    }

    // Whether it is MISSION_CLEAR_ALL and not MISSION_COUNT of no items, and of which type.
    private (bool IsClearAll, MavMissionType Type) TakeClearing()
    {
        Assert.True(_client.TryTakeFrame(_now, out MavlinkFrame frame));
        if (frame.TryDecode(out MissionClearAll clear))
            return (true, clear.MissionType);
        Assert.True(frame.TryDecode(out MissionCount count));
        Assert.Equal(0, count.Count);
        return (false, count.MissionType);
    }

    private void Answer(MavMissionType type, MavMissionResult result)
        => Receive(
            new MissionAck { Type = result, MissionType = type, TargetSystem = 1, TargetComponent = 191 });

    private (MavlinkMissionStatus Status, int Sent) Outcome()
    {
        Assert.True(_client.TryTakeOutcome(out MavlinkMissionOutcome outcome));
        return (outcome.Status, outcome.Sent);
    }

    private void Receive<T>(T message)
        where T : struct, IMavlinkMessage => _client.Handle(Vehicle.Create(message), _now);

    private MavlinkMissionOutcome RunToTheEnd()
    {
        MavlinkMissionOutcome outcome;
        while (!_client.TryTakeOutcome(out outcome))
        {
            _now = _client.NextDue > _now ? _client.NextDue : _now;
            while (_client.TryTakeFrame(_now, out _))
            {
                // the vehicle stays silent
            }
        }

        return outcome;
    }
}
