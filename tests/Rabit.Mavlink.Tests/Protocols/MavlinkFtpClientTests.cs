using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>The client of files, against the server of files and against components that serve less.</summary>
public class MavlinkFtpClientTests(ITestOutputHelper output)
{
    [Theory]
    [InlineData(0)]
    [InlineData(5)]
    [InlineData(20)]
    [InlineData(40)]
    public void Read_LossyLink_IsCompleteAndChecked(int lossPercent)
    {
        double longest = 0;
        for (ulong seed = 1; seed <= 20; seed++)
        {
            var vehicle = new FtpServerVehicle();
            var random = new ProtocolRandom(seed);
            byte[] content = Bytes(random, random.Below(60_000));
            byte[] other = Bytes(random, 5000);
            vehicle.Files.Set("targets/7.jpg", content);
            vehicle.Files.Set("targets/8.jpg", other);
            var world = new ProtocolWorld(vehicle, lossPercent, seed);
            MavlinkFtpClient client = New(new MavlinkFtpClientOptions { Retries = 20 });
            TimeSpan start = world.Now;
            Assert.Equal(MavlinkFtpStatus.Done, Read(world, client, "/targets/7.jpg").Status);
            longest = Math.Max(longest, (world.Now - start).TotalSeconds);
            Assert.True(content.AsSpan().SequenceEqual(client.Content.Span), world.Context);
            Assert.Equal(content.Length, client.BytesDone);

            // What is on its way of the first one is not taken for the second.
            MavlinkFtpOutcome second = Read(world, client, "targets/8.jpg");
            Assert.True(second is { Status: MavlinkFtpStatus.Done, IsChecked: true }, $"{world.Context}: {second}");
            Assert.True(other.AsSpan().SequenceEqual(client.Content.Span), world.Context);
            Assert.Equal(0, lossPercent == 0 ? vehicle.Server.OpenSessions : 0);
        }

        output.WriteLine($"loss {lossPercent} %, seeds 1 to 20: longest {longest:F1} s");
    }

    [Theory]
    [InlineData(0)]
    [InlineData(20)]
    public void List_LossyLink_HasAllEntries(int lossPercent)
    {
        for (ulong seed = 1; seed <= 20; seed++)
        {
            var vehicle = new FtpServerVehicle();
            for (int i = 0; i < 50; i++)
                vehicle.Files.Set($"many/file{i:D3}.bin", new byte[i]);
            vehicle.Files.Set("many/more/1.jpg", new byte[] { 1 });
            var world = new ProtocolWorld(vehicle, lossPercent, seed);
            MavlinkFtpClient client = New();
            Assert.True(client.TryStartList("many", world.Now));
            Assert.Equal(MavlinkFtpStatus.Done, Finish(world, client).Status);
            Assert.Equal(51, client.Entries.Count);
            Assert.Equal(new MavlinkFileEntry("file049.bin", 49, false), client.Entries[49]);
            Assert.Equal(new MavlinkFileEntry("more", 0, true), client.Entries[50]);
            Assert.True(client.TryStartList("/", world.Now));
            Finish(world, client);
            Assert.Equal([new MavlinkFileEntry("many", 0, true)], client.Entries);
        }
    }

    [Fact]
    public void Read_WhatIsNotThere_IsNotFound()
    {
        var world = new ProtocolWorld(new FtpServerVehicle(), 0, 1);
        MavlinkFtpClient client = New();
        Assert.Equal(MavlinkFtpStatus.NotFound, Read(world, client, "nothing").Status);
        Assert.Equal(0, client.Content.Length);
        Assert.True(client.TryStartList("nothing", world.Now));
        Assert.Equal(MavlinkFtpStatus.NotFound, Finish(world, client).Status);
    }

    [Fact]
    public void Read_AnEmptyFile_IsDone()
    {
        var vehicle = new FtpServerVehicle();
        vehicle.Files.Set("empty", Array.Empty<byte>());
        MavlinkFtpOutcome outcome = Read(new ProtocolWorld(vehicle, 0, 1), New(), "empty");
        Assert.True(outcome is { Status: MavlinkFtpStatus.Done, IsChecked: true });
    }

    [Fact]
    public void Read_ALargeFile_IsRefusedAndClosed()
    {
        var vehicle = new FtpServerVehicle();
        vehicle.Files.Set("large", new byte[1001]);
        MavlinkFtpClient client = New(new MavlinkFtpClientOptions { MaxFileSize = 1000 });
        Assert.Equal(MavlinkFtpStatus.TooLarge, Read(new ProtocolWorld(vehicle, 0, 1), client, "large").Status);
        Assert.Equal(0, vehicle.Server.OpenSessions);
    }

    [Fact]
    public void Read_WithAllSessionsInUse_IsRefusedWithItsReason()
    {
        var vehicle = new FtpServerVehicle();
        vehicle.Files.Set("1.jpg", new byte[100]);
        for (int i = 0; i < 4; i++)
        {
            MavlinkFtpClient each = New(sender: new MavlinkSender((byte)(200 + i), 190));
            each.TryStartRead("1.jpg", TimeSpan.Zero);
            Assert.True(each.TryTakeFrame(TimeSpan.Zero, out MavlinkFrame open));
            vehicle.Handle(open, TimeSpan.FromSeconds(100));
        }

        MavlinkFtpOutcome outcome = Read(new ProtocolWorld(vehicle, 0, 1), New(), "1.jpg");
        Assert.Equal(
            (MavlinkFtpStatus.Refused, (int)FtpError.NoSessionsAvailable), (outcome.Status, outcome.Error));
    }

    [Fact]
    public void Read_FromAComponentWithoutBurstsAndChecksums_IsDoneUnchecked()
    {
        var vehicle = new PlainFiles(Bytes(new ProtocolRandom(3), 5000));
        MavlinkFtpClient client = New();
        MavlinkFtpOutcome outcome = Read(new ProtocolWorld(vehicle, 0, 1), client, "1.jpg");
        Assert.Equal((MavlinkFtpStatus.Done, false), (outcome.Status, outcome.IsChecked));
        Assert.True(vehicle.Content.AsSpan().SequenceEqual(client.Content.Span));
    }

    [Fact]
    public void Read_AFileThatChanges_HasAWrongChecksum()
    {
        var vehicle = new FtpServerVehicle();
        vehicle.Files.Set("1.jpg", new byte[20_000]);
        var world = new ProtocolWorld(vehicle, 0, 1);
        MavlinkFtpClient client = New();
        client.TryStartRead("1.jpg", world.Now);
        world.RunUntil(
            () => client.BytesDone > 5000, client.Handle, client.TryTakeFrame, () => client.NextDue,
            TimeSpan.FromSeconds(10));
        vehicle.Files.Set("1.jpg", Bytes(new ProtocolRandom(1), 20_000));
        Assert.Equal(MavlinkFtpStatus.WrongChecksum, Finish(world, client).Status);
        Assert.Equal(0, vehicle.Server.OpenSessions);
    }

    [Fact]
    public void Read_WithoutAnAnswer_IsGivenUpAfterItsRetries()
    {
        MavlinkFtpClient client = New(new MavlinkFtpClientOptions { Retries = 3 });
        client.TryStartRead("1.jpg", TimeSpan.Zero);
        Assert.False(client.TryStartRead("2.jpg", TimeSpan.Zero));
        int sent = 0;
        TimeSpan now = TimeSpan.Zero;
        MavlinkFtpOutcome outcome;
        for (; !client.TryTakeOutcome(out outcome); now = client.NextDue)
            sent += client.TryTakeFrame(now, out _) ? 1 : 0;
        Assert.Equal((4, 4, MavlinkFtpStatus.Unanswered), (sent, outcome.Sent, outcome.Status));
        Assert.Equal(TimeSpan.MaxValue, client.NextDue);
        Assert.True(client.TryStartRead("2.jpg", now));
    }

    [Fact]
    public void Cancel_WhileItReads_ClosesTheFile()
    {
        var vehicle = new FtpServerVehicle();
        vehicle.Files.Set("1.jpg", new byte[20_000]);
        var world = new ProtocolWorld(vehicle, 0, 1);
        MavlinkFtpClient client = New();
        client.TryStartRead("1.jpg", world.Now);
        world.RunUntil(
            () => client.BytesDone > 5000, client.Handle, client.TryTakeFrame, () => client.NextDue,
            TimeSpan.FromSeconds(10));
        client.Cancel(world.Now);
        Assert.Equal(MavlinkFtpStatus.Cancelled, Finish(world, client).Status);
        Assert.Equal(0, vehicle.Server.OpenSessions);
        Assert.False(client.IsBusy);
    }

    [Theory]
    [InlineData(1, 2, 255, 190)]    // another component
    [InlineData(1, 1, 254, 190)]    // for another station
    [InlineData(1, 1, 0, 0)]        // for all
    public void Handle_AnAnswerThatIsNotForUs_IsIgnored(
        byte system, byte component, byte targetSystem, byte targetComponent)
    {
        MavlinkFtpClient client = New();
        client.TryStartRead("1.jpg", TimeSpan.Zero);
        client.TryTakeFrame(TimeSpan.Zero, out MavlinkFrame request);
        request.TryDecode(out FileTransferProtocol asked);
        var packet = new FtpPacket();
        asked.Payload.CopyTo(packet.Bytes);
        (packet.RequestOpcode, packet.Opcode) = (packet.Opcode, FtpOpcode.Nak);
        packet.Sequence++;
        client.Handle(
            MavlinkFrame.Create(
                new FileTransferProtocol
                {
                    TargetSystem = targetSystem,
                    TargetComponent = targetComponent,
                    Payload = new ByteArray251(packet.Bytes),
                },
                system, component, 0),
            TimeSpan.Zero);
        Assert.False(client.TryTakeOutcome(out _));
    }

    [Fact]
    public void Handle_RandomAnswers_NeverThrowsNorHangs()
    {
        for (ulong seed = 1; seed <= 200; seed++)
        {
            var random = new ProtocolRandom(seed);
            MavlinkFtpClient client = New(new MavlinkFtpClientOptions { MaxFileSize = 100_000 });
            bool isList = seed % 2 == 0;
            Assert.True(isList ? client.TryStartList("a", default) : client.TryStartRead("a", default));
            TimeSpan now = TimeSpan.Zero;
            var packet = new FtpPacket();
            for (int i = 0; i < 300 && !client.TryTakeOutcome(out _); i++)
            {
                now += TimeSpan.FromSeconds(0.1);
                if (client.TryTakeFrame(now, out MavlinkFrame request))
                {
                    request.TryDecode(out FileTransferProtocol asked);
                    asked.Payload.CopyTo(packet.Bytes);
                }

                packet.RequestOpcode = random.Below(4) == 0 ? (FtpOpcode)random.Below(17) : packet.RequestOpcode;
                if (packet.Opcode is not (FtpOpcode.Ack or FtpOpcode.Nak))
                    packet.RequestOpcode = packet.Opcode;
                packet.Opcode = random.Below(5) == 0 ? FtpOpcode.Nak : FtpOpcode.Ack;
                packet.Sequence++;
                packet.Size = (byte)random.Below(256);
                packet.Offset = random.Below(3) == 0 ? (uint)random.Next() : packet.Offset;
                for (int at = 0; at < 20; at++)
                    packet.Data[random.Below(FtpPacket.MaxData)] = (byte)random.Next();
                client.Handle(
                    MavlinkFrame.Create(
                        new FileTransferProtocol
                        {
                            TargetSystem = 255,
                            TargetComponent = 190,
                            Payload = new ByteArray251(packet.Bytes),
                        },
                        1, 1, 0),
                    now);
            }

            Assert.InRange(client.BytesDone, 0, 100_000);
        }
    }

    [Theory]
    [InlineData("")]
    [InlineData("a\0b")]
    public void TryStartRead_NoPath_Throws(string path)
        => Assert.Throws<ArgumentException>(() => New().TryStartRead(path, default));

    [Fact]
    public void Constructor_WrongOptions_Throw()
    {
        Assert.Throws<ArgumentNullException>(() => new MavlinkFtpClient(null!, new MavlinkAddress(1, 1)));
        Assert.Throws<ArgumentException>(
            () => new MavlinkFtpClient(new MavlinkSender(255, 190), new MavlinkAddress(1, 0)));
        Assert.Throws<ArgumentOutOfRangeException>(() => New(new MavlinkFtpClientOptions { Retries = -1 }));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => New(new MavlinkFtpClientOptions { AnswerTimeout = TimeSpan.Zero }));
    }

    private static MavlinkFtpClient New(MavlinkFtpClientOptions? options = null, MavlinkSender? sender = null)
        => new(sender ?? new MavlinkSender(255, 190), new MavlinkAddress(1, 1), options);

    private static byte[] Bytes(ProtocolRandom random, int count)
        => Enumerable.Range(0, count).Select(_ => (byte)random.Next()).ToArray();

    private static MavlinkFtpOutcome Read(ProtocolWorld world, MavlinkFtpClient client, string path)
    {
        Assert.True(client.TryStartRead(path, world.Now), world.Context);
        return Finish(world, client);
    }

    private static MavlinkFtpOutcome Finish(ProtocolWorld world, MavlinkFtpClient client)
    {
        MavlinkFtpOutcome outcome = default;
        bool ended = world.RunUntil(
            () => outcome.Status != MavlinkFtpStatus.None || client.TryTakeOutcome(out outcome), client.Handle,
            client.TryTakeFrame, () => client.NextDue, TimeSpan.FromSeconds(600));
        Assert.True(ended, world.Context);
        return outcome;
    }

    /// <summary>One file, without bursts and checksums.</summary>
    private sealed class PlainFiles(byte[] content) : ScriptedVehicle
    {
        private readonly FtpPacket _packet = new();

        public byte[] Content { get; } = content;

        public override void Handle(in MavlinkFrame frame, TimeSpan now)
        {
            if (!frame.TryDecode(out FileTransferProtocol message))
                return;
            message.Payload.CopyTo(_packet.Bytes);
            FtpOpcode asked = _packet.Opcode;
            (_packet.RequestOpcode, _packet.Opcode) = (asked, FtpOpcode.Ack);
            _packet.Sequence++;
            switch (asked)
            {
                case FtpOpcode.OpenFileReadOnly:
                    _packet.Size = 4;
                    BitConverter.GetBytes(Content.Length).CopyTo(_packet.Data);
                    break;
                case FtpOpcode.ReadFile:
                    int size = Math.Min(_packet.Size, Content.Length - (int)_packet.Offset);
                    Content.AsSpan((int)_packet.Offset, size).CopyTo(_packet.Data);
                    _packet.Size = (byte)size;
                    break;
                case FtpOpcode.TerminateSession: break;
                default:
                    (_packet.Opcode, _packet.Size) = (FtpOpcode.Nak, 1);
                    _packet.Data[0] = (byte)FtpError.UnknownCommand;
                    break;
            }

            Send(Sender.Create(new FileTransferProtocol
            {
                TargetSystem = frame.SystemId,
                TargetComponent = frame.ComponentId,
                Payload = new ByteArray251(_packet.Bytes),
            }));
        }
    }
}
