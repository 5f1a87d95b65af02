using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>
/// The commands of the recorded flights: the results that were acknowledged are the outcomes; heartbeats and clocks as
/// recorded.
/// </summary>
public class RecordedCommandTests
{
    [Theory]
    [InlineData("ardupilot-flight")]
    [InlineData("px4-flight")]
    public void Replay_EveryCommand_HasItsRecordedResult(string name)
    {
        using JsonDocument sidecar = TestData.Json(TestData.PathOf(name + ".json"));
        var recording = new RecordedExchange(name);
        JsonElement[] answers = sidecar.RootElement.GetProperty("command_acks").EnumerateArray().ToArray();
        var once = new MavlinkCommandOptions { LateAnswerTime = TimeSpan.Zero, Rejections = 0 };
        int checkedCommands = 0;
        foreach (JsonElement command in sidecar.RootElement.GetProperty("commands").EnumerateArray())
        {
            if (command.GetProperty("direction").GetString() != "tx")
                continue;
            int first = command.GetProperty("record").GetInt32();
            int id = command.GetProperty("command").GetInt32();
            JsonElement answer = answers.FirstOrDefault(
                entry => entry.GetProperty("record").GetInt32() > first
                    && entry.GetProperty("command").GetInt32() == id);
            if (answer.ValueKind == JsonValueKind.Undefined)
                continue;
            var client = new MavlinkCommandClient(ScriptedVehicle.Companion(), once);
            Assert.True(
                client.TryStart(CommandOf(recording.Frames[first].Frame), recording.Frames[first].At, out int handle));
            List<MavlinkFrame> sent = recording.Replay(
                first, answer.GetProperty("record").GetInt32(), client.Handle, client.TryTakeFrame);

            Assert.Equal(PayloadOf(recording.Frames[first].Frame), PayloadOf(sent[0]));
            Assert.True(client.TryTakeOutcome(out MavlinkCommandOutcome outcome), $"{name} record {first}: no outcome");
            Assert.Equal(
                (handle, (MavResult)answer.GetProperty("result").GetInt32()), (outcome.Handle, outcome.Result!.Value));
            Assert.Equal(
                outcome.Result == MavResult.Accepted ? MavlinkCommandStatus.Accepted : MavlinkCommandStatus.Refused,
                outcome.Status);
            checkedCommands++;
        }

        Assert.InRange(checkedCommands, 10, int.MaxValue);
    }

    [Theory]
    [InlineData("ardupilot-flight")]
    [InlineData("px4-flight")]
    public void Replay_Heartbeats_NoneIsLostOrRebooted(string name)
    {
        var recording = new RecordedExchange(name);
        var tracker = new MavlinkHeartbeatTracker();
        var events = new List<string>();
        foreach ((TimeSpan at, MavlinkFrame frame) in recording.Frames)
        {
            tracker.Handle(frame, at);
            while (tracker.TryTakeEvent(at, out MavlinkComponentEvent happened, out MavlinkComponent component))
                events.Add($"{happened} {component.Address.SystemId}/{component.Address.ComponentId}");
        }

        Assert.Equal(["Appeared 1/1", "Appeared 1/191"], events.OrderBy(line => line, StringComparer.Ordinal));
        Assert.Equal(
            recording.Frames.Count(entry => entry.Frame.MessageId == 0), tracker[0].Heartbeats + tracker[1].Heartbeats);
    }

    private static MavlinkCommand CommandOf(MavlinkFrame frame) => frame.TryDecode(out CommandLong command)
        ? MavlinkCommand.Create(
            ScriptedVehicle.Address, command.Command, command.Param1, command.Param2, command.Param3, command.Param4,
            command.Param5, command.Param6, command.Param7) with
        { Forms = MavlinkCommandForms.LongOnly }
        : frame.TryDecode(out CommandInt place)
            ? MavlinkCommand.AtLocation(
                ScriptedVehicle.Address, place.Command, place.Frame, place.X, place.Y, place.Z, place.Param1,
                place.Param2, place.Param3, place.Param4) with
            { Forms = MavlinkCommandForms.IntOnly }
            : default;

    private static string PayloadOf(MavlinkFrame frame)
    {
        var payload = new byte[MavlinkFrame.MaxPayloadLength];
        return TestData.ToHex(payload, frame.CopyPayloadTo(payload));
    }
}
