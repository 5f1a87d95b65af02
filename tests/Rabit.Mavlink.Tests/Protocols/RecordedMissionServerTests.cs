using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>The server gives the recorded companion what ArduPilot and PX4 gave it.</summary>
public class RecordedMissionServerTests
{
    [Theory]
    [InlineData("ardupilot-mission", true)]
    [InlineData("px4-mission", false)]
    public void Handle_RecordedTransfers_AnsweredAsRecorded(string name, bool isArduPilot)
    {
        using JsonDocument sidecar = TestData.Json(TestData.PathOf(name + ".json"));
        var recording = new RecordedExchange(name);
        var server = new MavlinkMissionServer(
            new MavlinkSender(1, 1), rules: null,
            new MavlinkMissionServerOptions { BehavesAsArduPilot = isArduPilot, SendsIds = false });
        int compared = 0;
        foreach (JsonElement transfer in sidecar.RootElement.GetProperty("mission_exchanges").EnumerateArray())
        {
            int last = transfer.GetProperty("last_record").GetInt32();
            for (int i = transfer.GetProperty("first_record").GetInt32(); i <= last; i++)
            {
                (System.TimeSpan at, MavlinkFrame frame) = recording.Frames[i];
                bool isRequest = frame.MessageId is MissionCount.MavlinkId or MissionItemInt.MavlinkId
                    or MissionRequestList.MavlinkId or MissionRequestInt.MavlinkId or MissionClearAll.MavlinkId;
                if (frame.ComponentId != 191 || !isRequest)
                    continue;
                server.Handle(frame, at);
                List<string> sent = [];
                while (server.TryTakeFrame(at, out MavlinkFrame answer))
                    sent.Add(LineOf(answer));
                string recorded = recording.Frames.Skip(i + 1).Select(entry => entry.Frame)
                    .Where(next => next.ComponentId == 1).Select(LineOf).First(line => line.Length > 0);
                Assert.Equal(recorded, Assert.Single(sent));
                compared++;
            }
        }

        Assert.Equal(3 * (1 + 1) + (2 * (32 + 5 + 3)) + 3, compared);
    }

    // What matters of an answer. ArduPilot's item 0 is home as it knows it, and it keeps centimetres; PX4 1.14 sends
    // its first request as MISSION_REQUEST, and fences and rally points without their type.
    private static string LineOf(MavlinkFrame frame)
    {
        if (frame.TryDecode(out MissionRequestInt request))
            return $"request {request.Seq} {request.MissionType} {request.TargetComponent}";
        if (frame.TryDecode(out MissionRequest old))
            return $"request {old.Seq} {old.MissionType} {old.TargetComponent}";
        if (frame.TryDecode(out MissionAck answer))
            return $"ack {answer.Type} {answer.MissionType} {answer.TargetComponent}";
        if (frame.TryDecode(out MissionCount count))
            return $"count {count.Count} {count.MissionType} {count.TargetComponent}";
        if (!frame.TryDecode(out MissionItemInt item))
            return "";
        return item.Seq == 0 && item.Command == MavCmd.NavWaypoint
            ? $"item 0 {item.TargetComponent}"
            : $"item {item.Seq} {item.Command} {item.X} {item.Y} {item.Z:F0} {item.TargetComponent}";
    }
}
