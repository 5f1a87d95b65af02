using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>The server answers the recorded requests as ArduPilot and PX4 did.</summary>
public class RecordedParameterServerTests
{
    [Theory]
    [InlineData("ardupilot-params", MavlinkParameterEncoding.CCast)]
    [InlineData("px4-params", MavlinkParameterEncoding.Bytewise)]
    public void Handle_RecordedRequests_AnsweredAsRecorded(string name, MavlinkParameterEncoding encoding)
    {
        using JsonDocument sidecar = TestData.Json(TestData.PathOf(name + ".json"));
        bool isPx4 = encoding == MavlinkParameterEncoding.Bytewise;
        var recording = new RecordedExchange(name);
        JsonElement[] requests = sidecar.RootElement.GetProperty("param_requests").EnumerateArray().ToArray();
        JsonElement[] values = sidecar.RootElement.GetProperty("param_values").EnumerateArray().ToArray();
        var server = new MavlinkParameterServer(
            new MavlinkSender(1, 1), ListOf(values, encoding), encoding,
            new MavlinkParameterServerOptions { SendsHash = isPx4, OmitsIndex = !isPx4, SendsErrors = false });
        int compared = 0;
        for (int i = 0; i < requests.Length; i++)
        {
            int record = requests[i].GetProperty("record").GetInt32();
            int end = i + 1 < requests.Length ? requests[i + 1].GetProperty("record").GetInt32() : int.MaxValue;
            server.Handle(recording.Frames[record].Frame, recording.Frames[record].At);
            List<string> sent = Take(server);
            bool isList = requests[i].GetProperty("message").GetString() == "PARAM_REQUEST_LIST";
            List<string> recorded = values
                .Where(value => value.GetProperty("record").GetInt32() > record
                    && value.GetProperty("record").GetInt32() < end && (isList || IsAnswer(requests[i], value)))
                .Select(LineOf).ToList();

            // ArduPilot left some of its list to be requested again; PX4 sends what was set twice.
            if (isList && isPx4)
                Assert.Equal(sent, recorded.Take(sent.Count));
            else if (isList)
                Assert.Equal(1354, sent.Count);
            else
                Assert.Equal(recorded.Distinct(), sent);
            compared += sent.Count;
        }

        Assert.Equal(isPx4 ? 882 + 11 : 1354 + 22, compared);
    }

    private static MavlinkParameterList ListOf(JsonElement[] values, MavlinkParameterEncoding encoding)
    {
        var list = new MavlinkParameterList();
        // ArduPilot was calibrating while its list was read: the later value; PX4's were set later.
        IEnumerable<JsonElement> listed = values.Where(value => value.GetProperty("index").GetInt32() != 65535)
            .GroupBy(value => value.GetProperty("index").GetInt32()).OrderBy(group => group.Key)
            .Select(group => encoding == MavlinkParameterEncoding.CCast ? group.Last() : group.First());
        foreach (JsonElement value in listed)
        {
            var type = (MavParamType)value.GetProperty("type").GetInt32();
            uint bits = BitConverter.ToUInt32(TestData.FromHex(value.GetProperty("raw").GetString()!), 0);
            list.Add(value.GetProperty("name").GetString()!, type, MavlinkParameter.Decode(bits, type, encoding));
        }

        return list;
    }

    private static bool IsAnswer(JsonElement request, JsonElement value)
        => request.GetProperty("name").GetString() is { Length: > 0 } name
            ? value.GetProperty("name").GetString() == name
            : value.GetProperty("index").GetInt32() == request.GetProperty("index").GetInt32();

    private static string LineOf(JsonElement value)
        => $"{value.GetProperty("name")} {value.GetProperty("type")} {value.GetProperty("raw")} "
            + $"{value.GetProperty("index")} of {value.GetProperty("count")}";

    private static List<string> Take(MavlinkParameterServer server)
    {
        var lines = new List<string>();
        TimeSpan now = server.NextDue;
        while (server.NextDue < TimeSpan.MaxValue)
        {
            now = server.NextDue > now ? server.NextDue : now;
            while (server.TryTakeFrame(now, out MavlinkFrame frame))
            {
                Assert.True(frame.TryDecode(out ParamValue value));
                byte[] raw = BitConverter.GetBytes(value.Value);
                lines.Add(
                    $"{value.ParamId} {(int)value.ParamType} {TestData.ToHex(raw, 4)} {value.ParamIndex} "
                        + $"of {value.ParamCount}");
            }
        }

        return lines;
    }
}
