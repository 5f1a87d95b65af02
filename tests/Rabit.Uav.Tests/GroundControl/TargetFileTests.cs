using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.GroundControl;

/// <summary>Image chips of targets by MAVLink FTP, and the messages that name them.</summary>
public sealed class TargetFileTests : IDisposable
{
    private const byte Open = 4;
    private const byte Read = 5;
    private const byte Acknowledged = 128;
    private const int HeaderLength = 12;

    private readonly byte[] _file = [.. Enumerable.Range(0, 500).Select(i => (byte)i)];
    private readonly List<(long Picture, int Report)> _asked = [];
    private readonly GroundRig _ground;

    public TargetFileTests() => _ground = new GroundRig(
        MissionRig.In(MissionPhase.Searching), picture: (picture, report) =>
        {
            _asked.Add((picture, report));
            return picture == 7 ? _file : null;
        });

    [Fact]
    public void ConfirmedTarget_ItsPicture_IsNamedOnceAndCanBeFetched()
    {
        Post(Track(3, picture: 7), Track(4, picture: 8), Track(5, picture: 9, TrackState.Tentative));
        Post(Track(3, picture: 7));
        CameraImageCaptured captured = Assert.Single(_ground.Take<CameraImageCaptured>());
        Assert.Equal("mftp://[;comp=191]targets/track-003.png", captured.FileUrl.ToString());
        Assert.Equal([(7L, 1), (8L, 1)], _asked);

        byte[] opened = Ask(Open, Encoding.ASCII.GetBytes("/targets/track-003.png"), 0);
        Assert.Equal(Acknowledged, opened[3]);
        Assert.Equal(_file.Length, BitConverter.ToInt32(opened, HeaderLength));
        var content = new List<byte>();
        while (content.Count < _file.Length)
        {
            byte[] part = Ask(Read, [], content.Count, opened[2]);
            Assert.Equal(Acknowledged, part[3]);
            content.AddRange(part.Skip(HeaderLength).Take(part[4]));
        }

        Assert.Equal(_file, content);
    }

    [Fact]
    public void BetterPicture_OfATarget_IsNamedAgain()
    {
        Post(Track(3, picture: 8));
        Assert.Empty(_ground.Take<CameraImageCaptured>());
        Post(Track(3, picture: 7));
        Assert.Equal(0, Assert.Single(_ground.Take<CameraImageCaptured>()).ImageIndex);
    }

    [Fact]
    public void Capabilities_WithFiles_SaySo()
    {
        _ground.Send(new CommandLong
        {
            Command = MavCmd.RequestMessage,
            Param1 = AutopilotVersion.MavlinkId,
            TargetSystem = 1,
            TargetComponent = GroundRig.Us,
        });
        _ground.Run(0.5);
        MavProtocolCapability capabilities = Assert.Single(_ground.Take<AutopilotVersion>()).Capabilities;
        Assert.Equal(MavProtocolCapability.Ftp, capabilities & MavProtocolCapability.Ftp);
    }

    public void Dispose() => _ground.Dispose();

    private static TargetTrack Track(int id, long picture, TrackState state = TrackState.Confirmed) => new()
    {
        Id = id,
        State = state,
        Class = DefaultTargetClasses.Red,
        BestPictureNumber = picture,
        BestReportIndex = 1,
    };

    private void Post(params TargetTrack[] tracks)
    {
        _ground.Tracks!.Value = new TrackList(TimeSpan.Zero, tracks);
        _ground.Tracks.Post();
        _ground.Run(0.5);
    }

    private byte[] Ask(byte opcode, byte[] data, int offset, byte session = 0)
    {
        var bytes = new byte[251];
        (bytes[0], bytes[2], bytes[3]) = ((byte)(offset + opcode), session, opcode);
        bytes[4] = opcode == Read ? (byte)239 : (byte)data.Length;
        BitConverter.GetBytes(offset).CopyTo(bytes, 8);
        data.CopyTo(bytes, HeaderLength);
        _ground.Send(new FileTransferProtocol
        {
            TargetSystem = 1,
            TargetComponent = GroundRig.Us,
            Payload = new ByteArray251(bytes),
        });
        _ground.Run(0.5);
        var answer = new byte[251];
        Assert.Single(_ground.Take<FileTransferProtocol>()).Payload.CopyTo(answer);
        return answer;
    }
}
