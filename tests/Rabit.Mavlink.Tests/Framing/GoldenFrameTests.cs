using System;
using System.Reflection;
using Rabit.Mavlink.Tests.Golden;
using Rabit.Mavlink.Tests.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>Every line of golden.jsonl in its three wire forms.</summary>
public class GoldenFrameTests
{
    private delegate MavlinkFrame Remake(in MavlinkFrame frame, MavlinkVersion version);

    [Fact]
    public void Read_EveryGoldenLine_GivesTheHeaderAndTheSameBytes()
    {
        int frames = 0;
        foreach (GoldenVector vector in GoldenVectors.All)
        {
            frames += Check(vector, vector.V1, MavlinkVersion.V1, isSigned: false);
            frames += Check(vector, vector.V2, MavlinkVersion.V2, isSigned: false);
            frames += Check(vector, vector.V2Signed, MavlinkVersion.V2, isSigned: true);
        }
        Assert.InRange(frames, (2 * 903) + 1, 3 * 903);
    }

    [Fact]
    public void Create_EveryGoldenLine_GivesTheListedBytes()
    {
        foreach (GoldenVector vector in GoldenVectors.All)
        {
            MavlinkFrame signed = Wire.Single(vector.V2Signed, out _);
            Remake remake = RemakeOf(MessageTypes.ById[vector.Id]);

            Assert.True(
                vector.V2.AsSpan().SequenceEqual(Wire.Bytes(remake(signed, MavlinkVersion.V2))),
                $"{vector} as MAVLink 2");
            if (vector.V1 is not null)
                Assert.True(
                    vector.V1.AsSpan().SequenceEqual(Wire.Bytes(remake(signed, MavlinkVersion.V1))),
                    $"{vector} as MAVLink 1");
        }
    }

    private static int Check(GoldenVector vector, byte[]? wire, MavlinkVersion version, bool isSigned)
    {
        if (wire is null)
            return 0;
        MavlinkFrame frame = Wire.Single(wire, out MavlinkFrameInfo info);
        Assert.True(info.IsChecked, vector.ToString());
        Assert.Equal(vector.Name, info.Message.Name);
        Assert.Equal((version, vector.Id, isSigned), (frame.Version, frame.MessageId, frame.IsSigned));
        Assert.Equal(
            (vector.SystemId, vector.ComponentId, vector.Sequence),
            (frame.SystemId, frame.ComponentId, frame.Sequence));
        Assert.Equal(wire, Wire.Bytes(frame));
        return 1;
    }

    private static Remake RemakeOf(Type message) => (Remake)Delegate.CreateDelegate(
        typeof(Remake),
        typeof(GoldenFrameTests).GetMethod(nameof(DecodeAndCreate), BindingFlags.NonPublic | BindingFlags.Static)!
            .MakeGenericMethod(message));

    private static MavlinkFrame DecodeAndCreate<T>(in MavlinkFrame frame, MavlinkVersion version)
        where T : struct, IMavlinkMessage
    {
        Assert.True(frame.TryDecode(out T message));
        return MavlinkFrame.Create(message, frame.SystemId, frame.ComponentId, frame.Sequence, version);
    }
}
