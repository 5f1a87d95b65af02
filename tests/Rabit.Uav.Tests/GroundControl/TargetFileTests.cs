using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.GroundControl;

/// <summary>Image chips of targets by MAVLink FTP, and the messages that name them.</summary>
public sealed class TargetFileTests : IDisposable
{
    private readonly byte[] _file = [.. Enumerable.Range(0, 500).Select(i => (byte)i)];
    private readonly List<(long Picture, int Report)> _asked = [];
    private readonly GroundRig _ground;
    private TimeSpan _now;

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

        var client = new MavlinkFtpClient(
            new MavlinkSender(GroundRig.Station, 190), new MavlinkAddress(1, GroundRig.Us));
        client.TryStartList("targets", TimeSpan.Zero);
        Assert.Equal(MavlinkFtpStatus.Done, Finish(client).Status);
        Assert.Equal([new MavlinkFileEntry("track-003.png", _file.Length, false)], client.Entries);
        client.TryStartRead("/targets/track-003.png", _now);
        Assert.True(Finish(client) is { Status: MavlinkFtpStatus.Done, IsChecked: true });
        Assert.Equal(_file, client.Content.ToArray());
        client.TryStartRead("targets/track-004.png", _now);
        Assert.Equal(MavlinkFtpStatus.NotFound, Finish(client).Status);
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

    private MavlinkFtpOutcome Finish(MavlinkFtpClient client)
    {
        MavlinkFtpOutcome outcome;
        for (int i = 0; !client.TryTakeOutcome(out outcome); i++)
        {
            Assert.InRange(i, 0, 200);
            while (client.TryTakeFrame(_now, out MavlinkFrame frame))
                _ground.Push(frame);
            _ground.Run(0.1);
            _now += TimeSpan.FromSeconds(0.1);
            foreach (FileTransferProtocol answer in _ground.Take<FileTransferProtocol>())
                client.Handle(MavlinkFrame.Create(answer, 1, GroundRig.Us, 0), _now);
        }

        return outcome;
    }
}
