using System;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Messages;

public class RoundTripTests(ITestOutputHelper output)
{
    [Fact]
    public void DecodeEncode_RandomPayloads_GiveTheSameBytes()
    {
        int seed = Environment.TickCount;
        output.WriteLine($"seed {seed}");
        var random = new Random(seed);
        foreach (Type type in MessageTypes.ById.Values)
        {
            for (int round = 0; round < 20; round++)
            {
                IMavlinkMessage message = MessageTypes.New(type);
                var payload = new byte[message.MaxLength];
                random.NextBytes(payload);
                message.Decode(payload);
                var encoded = new byte[message.MaxLength];
                message.Encode(encoded);
                Assert.Equal(payload, encoded);
            }
        }
    }

    [Fact]
    public void DecodeEncode_SignallingNaNs_KeepTheirBits()
    {
        foreach (Type type in MessageTypes.ById.Values)
        {
            // A float with these bytes is a signalling NaN wherever it begins, and so is a double.
            IMavlinkMessage message = MessageTypes.New(type);
            var payload = new byte[message.MaxLength];
            for (int i = 0; i < payload.Length; i++)
                payload[i] = (byte)(i % 4 == 3 ? 0x7F : i % 4 == 2 ? 0xA0 : i % 4);
            message.Decode(payload);
            var encoded = new byte[message.MaxLength];
            message.Encode(encoded);
            Assert.Equal(payload, encoded);
        }
    }

    [Fact]
    public void DecodeEncode_LongerSpan_TouchesOnlyItsOwnBytes()
    {
        foreach (Type type in MessageTypes.ById.Values)
        {
            IMavlinkMessage message = MessageTypes.New(type);
            var buffer = new byte[message.MaxLength + 2];
            for (int i = 0; i < buffer.Length; i++)
                buffer[i] = 0xA5;
            message.Decode(buffer);
            var encoded = new byte[buffer.Length];
            message.Encode(encoded);
            Assert.Equal(0xA5, encoded[message.MaxLength - 1]);
            Assert.Equal(0, encoded[message.MaxLength]);
        }
    }

    [Fact]
    public void DecodeEncode_ShorterSpan_IsRefusedByName()
    {
        foreach (Type type in MessageTypes.ById.Values)
        {
            IMavlinkMessage message = MessageTypes.New(type);
            var tooShort = new byte[message.MaxLength - 1];
            Assert.True(MavlinkDialect.All.TryGetMessage(message.MessageId, out MavlinkMessageInfo info));
            Assert.StartsWith(
                info.Name, Assert.Throws<ArgumentException>(() => message.Decode(tooShort)).Message,
                StringComparison.Ordinal);
            Assert.StartsWith(
                info.Name, Assert.Throws<ArgumentException>(() => message.Encode(tooShort)).Message,
                StringComparison.Ordinal);
        }
    }
}
