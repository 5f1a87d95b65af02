using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Protocols;

public class MavlinkFtpServerTests(ITestOutputHelper output)
{
    private readonly MavlinkSender _station = new(255, 190);
    private readonly MavlinkSender _other = new(254, 190);
    private readonly MavlinkMemoryFiles _files = new();
    private ushort _sequence;
    private TimeSpan _now = TimeSpan.FromSeconds(10);

    [Theory]
    [InlineData(0)]
    [InlineData(5)]
    [InlineData(20)]
    [InlineData(40)]
    public void Download_LossyLink_IsComplete(int lossPercent)
    {
        double longest = 0;
        for (ulong seed = 1; seed <= 20; seed++)
        {
            var vehicle = new FtpServerVehicle();
            var random = new ProtocolRandom(seed);
            byte[] content = new byte[random.Below(60_000)];
            for (int i = 0; i < content.Length; i++)
                content[i] = (byte)random.Next();
            vehicle.Files.Set("targets/7.jpg", content);
            var world = new ProtocolWorld(vehicle, lossPercent, seed);
            var download = new FtpDownload("/targets/7.jpg", ScriptedVehicle.Companion());
            TimeSpan start = world.Now;
            bool ended = world.RunUntil(
                () => download.IsOver, download.Handle, download.TryTakeFrame,
                () => download.IsOver ? TimeSpan.MaxValue : download.NextDue, TimeSpan.FromSeconds(600));
            Assert.True(ended, world.Context);
            longest = Math.Max(longest, (world.Now - start).TotalSeconds);

            // A lost answer to the last request is no loss: the file is closed then.
            Assert.True(
                download.Error == FtpError.None
                    || (lossPercent > 0 && download.Error == FtpError.InvalidSession),
                $"{world.Context}: {download.Error}");
            Assert.True(content.AsSpan().SequenceEqual(download.Content), world.Context);
            Assert.True(Crc32(content) == download.Checksum, world.Context);
            Assert.Equal((0, 0L), (vehicle.Server.OpenSessions, vehicle.Server.Dropped));
        }

        output.WriteLine($"loss {lossPercent} %, seeds 1 to 20: longest {longest:F1} s");
    }

    [Fact]
    public void List_FilesAndDirectories_InPagesToTheEnd()
    {
        _files.Set("targets/1.jpg", new byte[10]);
        _files.Set("targets/2.jpg", new byte[20]);
        _files.Set("/report.txt", new byte[3]);
        for (int i = 0; i < 50; i++)
            _files.Set($"many/file{i:D3}.bin", new byte[i]);
        MavlinkFtpServer server = New();
        Assert.Equal(["Dmany", "Freport.txt\t3", "Dtargets"], List(server, "/"));
        Assert.Equal(["F1.jpg\t10", "F2.jpg\t20"], List(server, "targets"));
        Assert.Equal(["F1.jpg\t10", "F2.jpg\t20"], List(server, "//targets/"));
        Assert.Equal(50, List(server, "many").Count);
        Assert.Equal(FtpError.FileNotFound, Ask(server, FtpOpcode.ListDirectory, path: "nothing").Error);
        Assert.Equal(0, Ask(server, FtpOpcode.ResetSessions).Session);
    }

    // Two servers would answer each other without end.
    [Fact]
    public void Handle_AnswersOfAnotherServer_AreNotAnswered()
    {
        MavlinkFtpServer server = New();
        foreach (FtpOpcode opcode in new[] { FtpOpcode.Ack, FtpOpcode.Nak })
        {
            var packet = new FtpPacket { Opcode = opcode, Sequence = 7 };
            var message = new FileTransferProtocol { TargetSystem = 1, TargetComponent = 191 };
            message.Payload = new ByteArray251(packet.Bytes);
            server.Handle(_station.Create(message), _now);
        }

        Assert.False(server.TryTakeFrame(_now, out _));
        Assert.Equal((0L, 0L), (server.Refusals, server.Dropped));
    }

    [Theory]
    [InlineData("../secret")]
    [InlineData("targets/../../secret")]
    [InlineData("./1.jpg")]
    [InlineData("targets\\1.jpg")]
    [InlineData("targets/1.jpg\n")]
    [InlineData("")]
    [InlineData("targets")]
    [InlineData("nothing")]
    public void Open_NoSuchFileOrBadPath_NotFound(string path)
    {
        _files.Set("targets/1.jpg", new byte[10]);
        var asked = new List<string>();
        MavlinkFtpServer server = New(files: new RecordingFileStore(_files, asked));
        Assert.Equal(FtpError.FileNotFound, Ask(server, FtpOpcode.OpenFileReadOnly, path: path).Error);
        Assert.Equal(FtpError.FileNotFound, Ask(server, FtpOpcode.CalculateCrc32, path: path).Error);
        Assert.Equal(2, server.Refusals);
        Assert.All(asked, each => Assert.True(each is "" or "targets" or "nothing", each));
    }

    [Theory]
    [InlineData((int)FtpOpcode.CreateFile, (int)FtpError.FileProtected)]
    [InlineData((int)FtpOpcode.WriteFile, (int)FtpError.FileProtected)]
    [InlineData((int)FtpOpcode.RemoveFile, (int)FtpError.FileProtected)]
    [InlineData((int)FtpOpcode.CreateDirectory, (int)FtpError.FileProtected)]
    [InlineData((int)FtpOpcode.RemoveDirectory, (int)FtpError.FileProtected)]
    [InlineData((int)FtpOpcode.OpenFileWriteOnly, (int)FtpError.FileProtected)]
    [InlineData((int)FtpOpcode.TruncateFile, (int)FtpError.FileProtected)]
    [InlineData((int)FtpOpcode.Rename, (int)FtpError.FileProtected)]
    [InlineData(16, (int)FtpError.UnknownCommand)]
    [InlineData(200, (int)FtpError.UnknownCommand)]
    public void Handle_WhatWritesOrIsUnknown_IsRefused(int opcode, int error)
    {
        _files.Set("1.jpg", new byte[10]);
        Assert.Equal((FtpError)error, Ask(New(), (FtpOpcode)opcode, path: "1.jpg").Error);
    }

    [Fact]
    public void Read_WithinAndBehindTheFile()
    {
        _files.Set("1.bin", Enumerable.Range(0, 200).Select(i => (byte)i).ToArray());
        MavlinkFtpServer server = New();
        Reply open = Ask(server, FtpOpcode.OpenFileReadOnly, path: "1.bin");
        Assert.Equal(200u, BitConverter.ToUInt32(open.Data, 0));
        Reply read = Ask(server, FtpOpcode.ReadFile, open.Session, offset: 190, size: 239);
        Assert.Equal(Enumerable.Range(190, 10).Select(i => (byte)i), read.Data);
        Assert.Equal((FtpOpcode.Ack, FtpOpcode.ReadFile, 190u), (read.Opcode, read.Request, read.Offset));
        Assert.Equal(FtpError.EndOfFile, Ask(server, FtpOpcode.ReadFile, open.Session, offset: 200, size: 1).Error);
        Assert.Equal(
            FtpError.EndOfFile, Ask(server, FtpOpcode.BurstReadFile, open.Session, offset: uint.MaxValue).Error);
        Assert.Equal(FtpError.InvalidSession, Ask(server, FtpOpcode.ReadFile, 3, size: 1).Error);
        Assert.Equal(FtpError.InvalidSession, Ask(server, FtpOpcode.ReadFile, 255, size: 1).Error);
        Assert.Equal(FtpError.InvalidDataSize, Ask(server, FtpOpcode.ReadFile, open.Session, size: 240).Error);

        // The file is replaced meanwhile: this download goes on with what it began.
        _files.Set("1.bin", new byte[1]);
        Assert.Equal(100, Assert.Single(Ask(server, FtpOpcode.ReadFile, open.Session, offset: 100, size: 1).Data));
    }

    [Fact]
    public void Handle_RepeatedRequest_SameAnswerNoSecondSession()
    {
        _files.Set("1.bin", new byte[10]);
        MavlinkFtpServer server = New();
        Reply first = Ask(server, FtpOpcode.OpenFileReadOnly, path: "1.bin");
        _sequence--;
        Assert.Equal(first.Session, Ask(server, FtpOpcode.OpenFileReadOnly, path: "1.bin").Session);
        Assert.Equal((1, 1), (server.OpenSessions, server.Repeats));

        // The answer to a close that was lost.
        Assert.Equal(FtpOpcode.Ack, Ask(server, FtpOpcode.TerminateSession, first.Session).Opcode);
        _sequence--;
        Assert.Equal(FtpOpcode.Ack, Ask(server, FtpOpcode.TerminateSession, first.Session).Opcode);
        Assert.Equal(
            FtpError.InvalidSession, Ask(server, FtpOpcode.TerminateSession, first.Session).Error);
    }

    [Fact]
    public void Sessions_AreLimitedOwnedAndTimeOut()
    {
        _files.Set("1.bin", new byte[10]);
        MavlinkFtpServer server = New(new MavlinkFtpServerOptions { MaxSessions = 2 });
        byte ours = Ask(server, FtpOpcode.OpenFileReadOnly, path: "1.bin").Session;
        byte theirs = Ask(server, FtpOpcode.OpenFileReadOnly, path: "1.bin", from: _other).Session;
        Assert.NotEqual(ours, theirs);
        Assert.Equal(
            FtpError.NoSessionsAvailable, Ask(server, FtpOpcode.OpenFileReadOnly, path: "1.bin").Error);
        Assert.Equal(FtpError.InvalidSession, Ask(server, FtpOpcode.ReadFile, theirs, size: 1).Error);
        Assert.Equal(FtpError.InvalidSession, Ask(server, FtpOpcode.TerminateSession, theirs).Error);
        Ask(server, FtpOpcode.ResetSessions);
        Assert.Equal(1, server.OpenSessions);

        _now += TimeSpan.FromSeconds(29);
        Assert.Equal(FtpOpcode.Ack, Ask(server, FtpOpcode.ReadFile, theirs, size: 1, from: _other).Opcode);
        _now += TimeSpan.FromSeconds(31);
        Assert.Equal(
            FtpError.InvalidSession, Ask(server, FtpOpcode.ReadFile, theirs, size: 2, from: _other).Error);
        Assert.Equal(0, server.OpenSessions);
    }

    [Fact]
    public void Burst_IsPacedNumberedAndEndedByAnotherRequest()
    {
        _files.Set("1.bin", new byte[239 * 30]);
        MavlinkFtpServer server = New(new MavlinkFtpServerOptions { BurstPackets = 5 });
        byte session = Ask(server, FtpOpcode.OpenFileReadOnly, path: "1.bin").Session;
        Send(server, _station, FtpOpcode.BurstReadFile, session, 0, 239, "");
        var packets = new List<Reply>();
        while (server.NextDue < TimeSpan.MaxValue)
        {
            _now = server.NextDue > _now ? server.NextDue : _now;
            packets.Add(Assert.Single(Take(server)));
        }

        Assert.Equal([0u, 239u, 478u, 717u, 956u], packets.Select(packet => packet.Offset));
        Assert.Equal(Enumerable.Range(_sequence + 1, 5), packets.Select(packet => (int)packet.Sequence));
        Assert.Equal([false, false, false, false, true], packets.Select(packet => packet.IsBurstComplete));

        Send(server, _station, FtpOpcode.BurstReadFile, session, 239 * 28, 0, "");
        Assert.Single(Take(server));
        Ask(server, FtpOpcode.ReadFile, session, 0, 1);
        Assert.Equal(TimeSpan.MaxValue, server.NextDue);
    }

    [Fact]
    public void Handle_ForOthers_IsIgnored()
    {
        MavlinkFtpServer server = New();
        server.Handle(_station.Create(new FileTransferProtocol { TargetSystem = 1, TargetComponent = 0 }), _now);
        server.Handle(_station.Create(new FileTransferProtocol { TargetSystem = 1, TargetComponent = 1 }), _now);
        Assert.Empty(Take(server));
    }

    [Fact]
    public void Handle_RandomPackets_AlwaysAnswered()
    {
        _files.Set("1.bin", new byte[1000]);
        MavlinkFtpServer server = New();
        var random = new ProtocolRandom(5);
        var bytes = new byte[FtpPacket.Length];
        for (int i = 0; i < 20_000; i++)
        {
            for (int at = 0; at < bytes.Length; at++)
                bytes[at] = random.Below(3) == 0 ? (byte)random.Next() : (byte)0;
            bytes[3] = (byte)random.Below(18);
            server.Handle(
                _station.Create(new FileTransferProtocol
                {
                    TargetSystem = 1,
                    TargetComponent = 191,
                    Payload = new ByteArray251(bytes),
                }), _now);
            Assert.True(Take(server).Count >= 1, $"packet {i}");
            _now += TimeSpan.FromMilliseconds(random.Below(1000));
        }
    }

    [Fact]
    public void Read_OfAnOpenFile_AllocatesNothing()
    {
        _files.Set("1.bin", new byte[100_000]);
        MavlinkFtpServer server = New();
        byte session = Ask(server, FtpOpcode.OpenFileReadOnly, path: "1.bin").Session;
        var packet = new FtpPacket
        {
            Opcode = FtpOpcode.BurstReadFile,
            Session = session,
            Size = FtpPacket.MaxData,
        };
        int packets = 0;
        Action work = () =>
        {
            packet.Sequence += 1000;
            server.Handle(_station.Create(new FileTransferProtocol
            {
                TargetSystem = 1,
                TargetComponent = 191,
                Payload = new ByteArray251(packet.Bytes),
            }), _now);
            for (; server.NextDue < TimeSpan.MaxValue; _now += TimeSpan.FromMilliseconds(1))
                packets += server.TryTakeFrame(_now, out _) ? 1 : 0;
        };
        work();
        Assert.Equal(100, packets);
        Assert.Equal(0, Allocated.By(work));
    }

    [Fact]
    public void BadInput_Throws()
    {
        Assert.Throws<ArgumentNullException>(() => new MavlinkFtpServer(null!, _files));
        Assert.Throws<ArgumentNullException>(() => new MavlinkFtpServer(_station, null!));
        Assert.Throws<ArgumentOutOfRangeException>(() => New(new MavlinkFtpServerOptions { MaxSessions = 0 }));
        Assert.Throws<ArgumentOutOfRangeException>(() => New(new MavlinkFtpServerOptions { BurstPackets = 0 }));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => New(new MavlinkFtpServerOptions { SessionTimeout = TimeSpan.Zero }));
        foreach (string path in new[] { "", "/", "../a", "a\\b", new string('x', 239) })
            Assert.Throws<ArgumentException>(() => _files.Set(path, default));
        _files.Set(new string('x', 238), default);
        Assert.False(_files.Remove("nothing"));
        Assert.True(_files.Remove("/" + new string('x', 238)));
        Assert.Equal(0, _files.Count);
    }

    private static uint Crc32(byte[] content)
    {
        uint hash = 0;
        foreach (byte value in content)
        {
            hash ^= value;
            for (int bit = 0; bit < 8; bit++)
                hash = (hash & 1) != 0 ? (hash >> 1) ^ 0xEDB88320 : hash >> 1;
        }

        return hash;
    }

    private MavlinkFtpServer New(MavlinkFtpServerOptions? options = null, IMavlinkFileStore? files = null)
        => new(new MavlinkSender(1, 191), files ?? _files, options);

    private List<string> List(MavlinkFtpServer server, string path)
    {
        var entries = new List<string>();
        while (true)
        {
            Reply reply = Ask(server, FtpOpcode.ListDirectory, offset: (uint)entries.Count, path: path);
            if (reply.Opcode == FtpOpcode.Nak)
            {
                Assert.Equal(FtpError.EndOfFile, reply.Error);
                return entries;
            }

            entries.AddRange(Encoding.UTF8.GetString(reply.Data).TrimEnd('\0').Split('\0'));
        }
    }

    private Reply Ask(
        MavlinkFtpServer server, FtpOpcode opcode, byte session = 0, uint offset = 0, byte size = 0, string path = "",
        MavlinkSender? from = null)
    {
        Send(server, from ?? _station, opcode, session, offset, size, path);
        Reply reply = Assert.Single(Take(server));
        Assert.Equal((ushort)(_sequence + 1), reply.Sequence);
        return reply;
    }

    private void Send(
        MavlinkFtpServer server, MavlinkSender from, FtpOpcode opcode, byte session, uint offset, byte size,
        string path)
    {
        var packet = new FtpPacket
        {
            Sequence = ++_sequence,
            Opcode = opcode,
            Session = session,
            Offset = offset,
            Size = path.Length > 0 ? (byte)path.Length : size,
        };
        Encoding.UTF8.GetBytes(path).CopyTo(packet.Data);
        server.Handle(from.Create(new FileTransferProtocol
        {
            TargetSystem = 1,
            TargetComponent = 191,
            Payload = new ByteArray251(packet.Bytes),
        }), _now);
    }

    private List<Reply> Take(MavlinkFtpServer server)
    {
        var replies = new List<Reply>();
        while (server.TryTakeFrame(_now, out MavlinkFrame frame))
        {
            Assert.True(frame.TryDecode(out FileTransferProtocol message));
            var packet = new FtpPacket();
            message.Payload.CopyTo(packet.Bytes);
            replies.Add(new Reply(packet));
        }

        return replies;
    }

    private sealed class Reply(FtpPacket packet)
    {
        public ushort Sequence { get; } = packet.Sequence;

        public FtpOpcode Opcode { get; } = packet.Opcode;

        public FtpOpcode Request { get; } = packet.RequestOpcode;

        public byte Session { get; } = packet.Session;

        public uint Offset { get; } = packet.Offset;

        public bool IsBurstComplete { get; } = packet.IsBurstComplete;

        public byte[] Data { get; } = packet.Data.Slice(0, packet.Size).ToArray();

        public FtpError Error => Opcode == FtpOpcode.Nak ? (FtpError)Data[0] : FtpError.None;
    }
}
