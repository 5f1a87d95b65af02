using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>
/// The recorded transfers of ArduPilot and PX4: the client at their companion's end sends what they asked for and
/// receives what they sent.
/// </summary>
public class RecordedMissionTests
{
    [Theory]
    [InlineData("ardupilot-mission")]
    [InlineData("px4-mission")]
    public void Replay_EveryTransfer_AgreesWithTheSidecar(string name)
    {
        using JsonDocument sidecar = TestData.Json(TestData.PathOf(name + ".json"));
        var recording = new RecordedExchange(name);
        int transfers = 0;
        foreach (JsonElement transfer in sidecar.RootElement.GetProperty("mission_exchanges").EnumerateArray())
        {
            int first = transfer.GetProperty("first_record").GetInt32();
            int last = transfer.GetProperty("last_record").GetInt32();
            var type = (MavMissionType)transfer.GetProperty("mission_type").GetInt32();
            var client = new MavlinkMissionClient(ScriptedVehicle.Companion(), ScriptedVehicle.Address);
            MissionItemInt[] listed = transfer.TryGetProperty("items", out JsonElement items)
                ? items.EnumerateArray().Select(ItemOf).ToArray()
                : [];
            TimeSpan now = recording.Frames[first].At;
            string kind = transfer.GetProperty("kind").GetString()!;
            Assert.True(
                kind == "upload" ? client.TryStartUpload(type, listed, now)
                    : kind == "download" ? client.TryStartDownload(type, now)
                    : client.TryStartClear(type, now));
            List<MavlinkFrame> sent = recording.Replay(first, last, client.Handle, client.TryTakeFrame);

            Assert.True(client.TryTakeOutcome(out MavlinkMissionOutcome outcome), $"{name} {kind} {type}: no outcome");
            Assert.Equal(MavlinkMissionStatus.Done, outcome.Status);
            if (kind == "upload")
                Assert.Equal(
                    SentItems(recording, first, last), sent.Where(IsItem).Select(PayloadOf), StringComparer.Ordinal);
            if (kind == "download")
                Assert.Equal(
                    listed.Select(item => item with { TargetSystem = 0, TargetComponent = 0 }),
                    client.Items.ToArray().Select(item => item with { TargetSystem = 0, TargetComponent = 0 }));
            transfers++;
        }

        Assert.Equal(9, transfers);
    }

    private static bool IsItem(MavlinkFrame frame) => frame.MessageId == MissionItemInt.MavlinkId;

    private static IEnumerable<string> SentItems(RecordedExchange recording, int first, int last)
        => recording.Frames.Skip(first).Take(last - first + 1)
            .Select(entry => entry.Frame).Where(frame => frame.ComponentId == 191 && IsItem(frame)).Select(PayloadOf);

    private static string PayloadOf(MavlinkFrame frame)
    {
        var payload = new byte[MavlinkFrame.MaxPayloadLength];
        return TestData.ToHex(payload, frame.CopyPayloadTo(payload));
    }

    private static MissionItemInt ItemOf(JsonElement item)
    {
        JsonElement parameters = item.GetProperty("params");
        return new MissionItemInt
        {
            Seq = item.GetProperty("seq").GetUInt16(),
            Frame = (MavFrame)item.GetProperty("frame").GetInt32(),
            Command = (MavCmd)item.GetProperty("command").GetInt32(),
            Current = item.GetProperty("current").GetByte(),
            Autocontinue = item.GetProperty("autocontinue").GetByte(),
            Param1 = NumberOf(parameters[0]),
            Param2 = NumberOf(parameters[1]),
            Param3 = NumberOf(parameters[2]),
            Param4 = NumberOf(parameters[3]),
            X = item.GetProperty("x").GetInt32(),
            Y = item.GetProperty("y").GetInt32(),
            Z = NumberOf(item.GetProperty("z")),
            MissionType = (MavMissionType)item.GetProperty("mission_type").GetInt32(),
        };
    }

    private static float NumberOf(JsonElement value) => value.ValueKind == JsonValueKind.Number
        ? (float)value.GetDouble()
        : string.Equals(value.GetString(), "nan", StringComparison.Ordinal) ? MavlinkParameter.ToFloat(0x7FC00000)
        : float.Parse(value.GetString()!, CultureInfo.InvariantCulture);
}
