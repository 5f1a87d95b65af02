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
