using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink.Tests.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>edge.jsonl: single frames at the borders of the rules.</summary>
public class EdgeCaseTests
{
    [Fact]
    public void Read_EveryEdgeCase_DeliversOrDropsAsListed()
    {
        int cases = 0;
        foreach (JsonElement line in TestData.Lines("edge.jsonl"))
        {
            string name = $"{line.GetProperty("case")} {line.GetProperty("name")}";
            byte[] wire = TestData.FromHex(line.GetProperty("hex").GetString()!);
            var reader = new MavlinkFrameReader(MavlinkDialect.All);
            List<FoundFrame> found = FrameCollector.Read(wire, wire.Length, reader)
                .Where(frame => frame.Info.IsChecked).ToList();

            string expected = line.GetProperty("expect").GetString()!;
            if (expected != "either")
                Assert.True(found.Count == (expected == "deliver" ? 1 : 0), name);
            foreach (FoundFrame frame in found)
                AssertWholeAndDecodable(line.GetProperty("id").GetInt32(), wire, frame.Frame, name);
            cases++;
        }
        Assert.Equal(180, cases);
    }

    // What is decoded and encoded again is the payload: cut bytes as zeros, bytes behind the known fields gone.
    private static void AssertWholeAndDecodable(int id, byte[] wire, in MavlinkFrame frame, string name)
    {
        Assert.True(wire.AsSpan().SequenceEqual(Wire.Bytes(frame)), name);
        Assert.True(frame.MessageId == id, name);
        var payload = new byte[MavlinkFrame.MaxPayloadLength];
        frame.CopyPayloadTo(payload);
        IMavlinkMessage message = MessageTypes.New(MessageTypes.ById[id]);
        message.Decode(payload);
        var encoded = new byte[message.MaxLength];
        message.Encode(encoded);
        Assert.True(payload.AsSpan(0, encoded.Length).SequenceEqual(encoded), name);
    }
}
