using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>The recorded lists, reads and sets of ArduPilot and PX4.</summary>
public class RecordedParameterTests
{
    [Theory]
    [InlineData("ardupilot-params", MavlinkParameterEncoding.CCast)]
    [InlineData("px4-params", MavlinkParameterEncoding.Bytewise)]
    public void Replay_EveryRequest_AgreesWithTheSidecar(string name, MavlinkParameterEncoding encoding)
    {
        using JsonDocument sidecar = TestData.Json(TestData.PathOf(name + ".json"));
        JsonElement facts = sidecar.RootElement;
        var recording = new RecordedExchange(name);
        var client = new MavlinkParameterClient(
            ScriptedVehicle.Companion(), ScriptedVehicle.Address, encoding,
            new MavlinkParameterOptions { LateAnswerTime = TimeSpan.Zero, EmptyRounds = 100 });
        JsonElement[] requests = facts.GetProperty("param_requests").EnumerateArray().ToArray();
        int list = requests[0].GetProperty("record").GetInt32();

        // The list with whatever was asked for again by index, up to the first read by name.
        int afterList = Array.FindIndex(
            requests, request => request.TryGetProperty("name", out JsonElement text) && text.GetString()!.Length > 0);
        int end = requests[afterList].GetProperty("record").GetInt32();
        Assert.True(client.TryStartList(recording.Frames[list].At));
        recording.Replay(list, end - 1, client.Handle, client.TryTakeFrame);
        Assert.True(client.TryTakeOutcome(out MavlinkParameterOutcome outcome));
        Assert.Equal((MavlinkParameterStatus.Done, 0), (outcome.Status, outcome.Missing));
        Assert.Equal(facts.GetProperty("param_count").GetInt32(), client.Parameters.Count);
        Assert.Equal(Listed(facts, end), Known(client), StringComparer.Ordinal);

        // The hash that stood before the list is that of the list, computed here.
        if (encoding == MavlinkParameterEncoding.Bytewise)
            Assert.Equal(client.Hash, MavlinkParameterHash.Compute(client.Parameters));

        // One after another; what was not answered in the recording is not answered here.
        int done = 0;
        for (int i = afterList; i < requests.Length; i++)
        {
            int first = requests[i].GetProperty("record").GetInt32();
            int last = i + 1 < requests.Length
                ? requests[i + 1].GetProperty("record").GetInt32() - 1
                : recording.Frames.Count - 1;
            string parameter = requests[i].GetProperty("name").GetString()!;
            bool isSet = requests[i].TryGetProperty("raw", out JsonElement raw);
            Start(client, requests[i], parameter, isSet ? raw.GetString() : null, recording.Frames[first].At);
            List<MavlinkFrame> sent = recording.Replay(first, last, client.Handle, client.TryTakeFrame);
            Assert.Equal(PayloadOf(recording.Frames[first].Frame), PayloadOf(sent[0]));
            if (client.TryTakeOutcome(out outcome) && outcome.Status == MavlinkParameterStatus.Done)
                done++;
            client.Cancel(recording.Frames[last].At);
            client.TryTakeOutcome(out _);
            bool isAnswered = IsAnswered(facts, requests[i], parameter, first, last);
            Assert.True(isAnswered == (outcome.Status == MavlinkParameterStatus.Done), $"{parameter}: {outcome}");
        }

        Assert.InRange(done, 5, requests.Length);
        Assert.Equal(Listed(facts, int.MaxValue), Known(client), StringComparer.Ordinal);
        Assert.Equal(encoding == MavlinkParameterEncoding.Bytewise, client.Hash is not null);
    }

    private static void Start(
        MavlinkParameterClient client, JsonElement request, string name, string? raw, TimeSpan now)
    {
        if (raw is not null)
        {
            var type = (MavParamType)request.GetProperty("type").GetInt32();
            uint bits = BitConverter.ToUInt32(TestData.FromHex(raw), 0);
            Assert.True(client.TryStartSet(name, type, MavlinkParameter.Decode(bits, type, client.Encoding), now));
        }
        else
        {
            int index = request.GetProperty("index").GetInt32();
            Assert.True(index >= 0 ? client.TryStartRead(index, now) : client.TryStartRead(name, now));
        }
    }

    private static bool IsAnswered(JsonElement facts, JsonElement request, string name, int first, int last)
        => facts.GetProperty("param_values").EnumerateArray()
            .Any(value => value.GetProperty("record").GetInt32() > first
                && value.GetProperty("record").GetInt32() <= last
                && (name.Length > 0
                    ? value.GetProperty("name").GetString() == name
                    : value.GetProperty("index").GetInt32() == request.GetProperty("index").GetInt32()));

    private static string PayloadOf(MavlinkFrame frame)
    {
        var payload = new byte[MavlinkFrame.MaxPayloadLength];
        return TestData.ToHex(payload, frame.CopyPayloadTo(payload));
    }

    // The last value of every name.
    private static List<string> Listed(JsonElement facts, int end)
    {
        var values = new Dictionary<string, string>(StringComparer.Ordinal);
        foreach (JsonElement value in facts.GetProperty("param_values").EnumerateArray())
        {
            if (value.GetProperty("record").GetInt32() < end && value.GetProperty("name").GetString() != "_HASH_CHECK")
                values[value.GetProperty("name").GetString()!] =
                    $"{value.GetProperty("type")} {value.GetProperty("value").GetDouble():R}";
        }

        return values.Select(pair => $"{pair.Key} {pair.Value}").OrderBy(line => line, StringComparer.Ordinal).ToList();
    }

    private static List<string> Known(MavlinkParameterClient client)
        => Enumerable.Range(0, client.Parameters.Count).Select(index => client.Parameters[index])
            .Select(parameter => $"{parameter.Name} {(int)parameter.Type} {parameter.ToDouble(client.Encoding):R}")
            .OrderBy(line => line, StringComparer.Ordinal)
            .ToList();
}
