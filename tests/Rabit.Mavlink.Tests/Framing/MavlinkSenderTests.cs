using System;
using System.Reflection;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Golden;
using Rabit.Mavlink.Tests.Messages;
using Rabit.Mavlink.Tests.Signing;
using Xunit;

namespace Rabit.Mavlink.Tests.Framing;

public class MavlinkSenderTests
{
    private delegate byte[] Remake(in MavlinkFrame frame, MavlinkVersion version, int room);

    private readonly MavlinkSender _sender = new(7, 191);
    private readonly byte[] _buffer = new byte[MavlinkFrame.MaxWireLength];

    [Fact]
    public void Write_EveryGoldenLine_GivesWhatCreateGivesInBothVersions()
    {
        foreach (GoldenVector vector in GoldenVectors.All)
        {
            MavlinkFrame frame = Wire.Single(vector.V2, out _);
            Remake remake = RemakeOf(nameof(DecodeAndWrite), vector.Id);
            Remake create = RemakeOf(nameof(DecodeAndCreate), vector.Id);
            foreach (MavlinkVersion version in new[] { MavlinkVersion.V1, MavlinkVersion.V2 })
            {
                if (version == MavlinkVersion.V1 && vector.Id > 255)
                    continue;
                byte[] expected = create(frame, version, 0);
                Assert.Equal(expected, remake(frame, version, MavlinkFrame.MaxWireLength));
                Assert.Equal(expected, remake(frame, version, expected.Length));
            }
        }
    }

    [Fact]
    public void Create_FrameAfterFrame_CountsTo255AndBeginsAgain()
    {
        for (int frame = 0; frame < 600; frame++)
        {
            MavlinkFrame made = _sender.Create(default(Heartbeat));
            Assert.Equal(((byte)frame, (byte)7, (byte)191), (made.Sequence, made.SystemId, made.ComponentId));
            Assert.Equal((byte)(frame + 1), _sender.NextSequence);
        }
    }

    [Fact]
    public void Write_Span_IsTheFrameThatCreateMakes()
    {
        int length = _sender.Write(new Attitude { Yaw = 1 }, _buffer.AsSpan());

        Assert.Equal(
            Wire.Bytes(new MavlinkSender(7, 191).Create(new Attitude { Yaw = 1 })),
            _buffer.AsSpan(0, length).ToArray());
    }

    [Fact]
    public void Write_BufferWriter_AppendsFrameByFrame()
    {
        var buffer = new GrowingBuffer();
        int length = _sender.Write(new Attitude { Yaw = 1 }, buffer);
        length += _sender.Write(default(Heartbeat), buffer);
        length += _sender.Create(default(Ping)).WriteTo(buffer);

        Assert.Equal(length, buffer.Written.Length);
        var found = FrameCollector.Read(buffer.Written, 5, new MavlinkFrameReader(MavlinkDialect.All));
        Assert.Equal(
            [Attitude.MavlinkId, Heartbeat.MavlinkId, Ping.MavlinkId],
            found.ConvertAll(frame => frame.Frame.MessageId));
        Assert.Equal([0, 1, 2], found.ConvertAll(frame => (int)frame.Frame.Sequence));
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Write_SpanOneByteTooShort_IsRefusedAndNoNumberIsUsedUp(bool isSigned)
    {
        if (isSigned)
            _sender.Signer = new MavlinkSigner(Keys.One, 0, Keys.ClockAt(Keys.Noon));
        var message = new Attitude { Yawspeed = 1 };
        int length = new MavlinkSender(7, 191) { Signer = _sender.Signer }.Write(message, _buffer.AsSpan());

        Assert.Throws<ArgumentException>(() => _sender.Write(message, _buffer.AsSpan(0, length - 1)));
        Assert.Equal(0, _sender.NextSequence);
        Assert.Equal(length, _sender.Write(message, _buffer.AsSpan(0, length)));
    }

    [Fact]
    public void Write_Mavlink1_IsMavlink1()
    {
        _sender.Version = MavlinkVersion.V1;
        int length = _sender.Write(default(Heartbeat), _buffer.AsSpan());

        Assert.Equal(Wire.Of(default(Heartbeat), 0, MavlinkVersion.V1).Length, length);
        Assert.Equal(0xFE, _buffer[0]);
        Assert.Throws<ArgumentException>(() => _sender.Write(default(SetupSigning), _buffer.AsSpan()));
        Assert.Equal(1, _sender.NextSequence);
    }

    [Fact]
    public void Write_WithASigner_Signs()
    {
        _sender.Signer = new MavlinkSigner(Keys.One, 5, Keys.ClockAt(Keys.Noon));
        int length = _sender.Write(default(Heartbeat), _buffer.AsSpan());
        MavlinkFrame written = Wire.Single(_buffer.AsSpan(0, length).ToArray(), out _);
        MavlinkFrame created = _sender.Create(default(Heartbeat));

        Assert.All(new[] { written, created }, frame => Assert.True(Keys.One.Matches(frame)));
        Assert.Equal(
            (Keys.Noon, Keys.Noon + 1, (byte)5),
            (written.SignatureTimestamp, created.SignatureTimestamp, created.SignatureLinkId));
    }

    [Fact]
    public void Mavlink1AndSigner_EitherWay_IsRefused()
    {
        var signer = new MavlinkSigner(Keys.One, 0, Keys.ClockAt(Keys.Noon));
        Assert.Throws<InvalidOperationException>(
            () => new MavlinkSender(1, 1) { Version = MavlinkVersion.V1 }.Signer = signer);
        Assert.Throws<InvalidOperationException>(
            () => new MavlinkSender(1, 1) { Signer = signer }.Version = MavlinkVersion.V1);
    }

    [Theory]
    [InlineData(0, 1)]
    [InlineData(1, 0)]
    public void New_IdZero_IsRefused(byte systemId, byte componentId) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new MavlinkSender(systemId, componentId));

    [Fact]
    public void Version_NeitherOneNorTwo_IsRefused()
        => Assert.Throws<ArgumentOutOfRangeException>(() => _sender.Version = MavlinkVersion.None);

    private static Remake RemakeOf(string method, int messageId) => (Remake)Delegate.CreateDelegate(
        typeof(Remake),
        typeof(MavlinkSenderTests).GetMethod(method, BindingFlags.NonPublic | BindingFlags.Static)!
            .MakeGenericMethod(MessageTypes.ById[messageId]));

    private static byte[] DecodeAndWrite<T>(in MavlinkFrame frame, MavlinkVersion version, int room)
        where T : struct, IMavlinkMessage
    {
        Assert.True(frame.TryDecode(out T message));
        byte[] buffer = new byte[room];
        buffer.AsSpan().Fill(0xA5);
        int length = new MavlinkSender(7, 191) { Version = version }.Write(message, buffer.AsSpan());
        return buffer.AsSpan(0, length).ToArray();
    }

    private static byte[] DecodeAndCreate<T>(in MavlinkFrame frame, MavlinkVersion version, int room)
        where T : struct, IMavlinkMessage
    {
        Assert.True(frame.TryDecode(out T message));
        return Wire.Bytes(MavlinkFrame.Create(message, 7, 191, 0, version));
    }
}
