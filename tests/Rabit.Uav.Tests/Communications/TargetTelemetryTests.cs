using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Targets for the maps of ground stations.</summary>
public sealed class TargetTelemetryTests : IDisposable
{
    private MessagePublisher<TrackList>? _tracks;
    private CommunicationsRig? _rig;

    public void Dispose() => _rig?.Dispose();

    [Fact]
    public void Targets_Confirmed_AreSentInTheirTurnOneASecond()
    {
        CommunicationsRig rig = Rig();
        Publish(Track(7), Track(3), Track(5, TrackState.Tentative));
        rig.Run(TimeSpan.FromSeconds(9.9));
        int[] norths = Decoded<CameraTrackingGeoStatus>(rig, 0).Select(m => (m.Lat - 474_000_000) / 100).ToArray();
        Assert.Equal([3, 7, 3, 7, 3, 7, 3, 7, 3, 7], norths);
    }

    [Fact]
    public void Targets_Content_IsThatOfTheTrack()
    {
        CommunicationsRig rig = Rig();
        Publish(Track(3));
        rig.Run(TimeSpan.FromSeconds(0.5));
        CameraTrackingGeoStatus status = Assert.Single(Decoded<CameraTrackingGeoStatus>(rig, 0));
        Assert.Equal((474_000_300, 85_000_000, 488f), (status.Lat, status.Lon, status.Alt));
        Assert.Equal((float)Math.Sqrt(2.5), status.HAcc);
        Assert.Equal(CameraTrackingStatusFlags.Active, status.TrackingStatus);
    }

    [Fact]
    public void Targets_Confirmed_AreNamedOnceWithTheirCoordinates()
    {
        CommunicationsRig rig = Rig();
        Publish(Track(3), Track(4));
        rig.Run(TimeSpan.FromSeconds(10));
        string[] texts = Decoded<Statustext>(rig, 0).Select(t => t.Text.ToString()).ToArray();
        Assert.Equal(
            ["Rabit: target 3 red 47.40003,8.50000 +-3 m", "Rabit: target 4 red 47.40004,8.50000 +-3 m"], texts);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Targets_AsTraffic_GoToGroundStationsOnly(bool isChosen)
    {
        CommunicationsRig rig = Rig(links: 4, o => o.SendsTargetsAsTraffic = isChosen);
        for (int second = 0; second < 5; second++)
        {
            Heartbeat(rig, 0, 255, MavType.Gcs, MavAutopilot.Invalid);
            Heartbeat(rig, 1, 1, MavType.Quadrotor, MavAutopilot.Px4);
            Heartbeat(rig, 2, 255, MavType.Gcs, MavAutopilot.Invalid);
            Heartbeat(rig, 2, 1, MavType.Quadrotor, MavAutopilot.Ardupilotmega);
            Publish(Track(12));
            rig.Run(TimeSpan.FromSeconds(1));
        }

        int[] counts = Enumerable.Range(0, 4).Select(link => Decoded<AdsbVehicle>(rig, link).Count).ToArray();
        Assert.Equal([isChosen ? 1 : 0, 0, 0, 0], counts.Select(c => Math.Min(1, c)));
    }

    [Fact]
    public void Targets_AsTraffic_HaveAnAddressOfNoAircraftAndTheirNumber()
    {
        CommunicationsRig rig = Rig(configure: o => o.SendsTargetsAsTraffic = true);
        Heartbeat(rig, 0, 255, MavType.Gcs, MavAutopilot.Invalid);
        rig.Run(TimeSpan.FromSeconds(1));
        Publish(Track(12));
        rig.Run(TimeSpan.FromSeconds(1));
        AdsbVehicle traffic = Decoded<AdsbVehicle>(rig, 0)[0];
        Assert.Equal(
            (0xF0_100Cu, "TGT012", 488_000),
            (traffic.IcaoAddress, traffic.Callsign.ToString(), traffic.Altitude));
    }

    private CommunicationsRig Rig(int links = 1, Action<CommunicationsOptions>? configure = null)
        => _rig = new CommunicationsRig(
            links,
            o =>
            {
                (o.SendsTargets, o.PositionRateHz) = (true, 0);
                configure?.Invoke(o);
            },
            beforeStart: reactor => _tracks = reactor.Workspace.Publish(MessageNames.Tracks, TrackList.None)).As(1);

    private void Publish(params TargetTrack[] tracks)
    {
        _tracks!.Value = new TrackList(TimeSpan.Zero, tracks);
        _tracks.Post();
    }

    private static TargetTrack Track(int id, TrackState state = TrackState.Confirmed) => new()
    {
        Id = id,
        State = state,
        Class = DefaultTargetClasses.Red,
        Position = GeodeticPosition.FromDegrees(47.4 + (id * 1e-5), 8.5, 488),
        Covariance = new HorizontalCovariance(1.25, 0, 1.25),
    };

    private static void Heartbeat(CommunicationsRig rig, int link, byte system, MavType type, MavAutopilot autopilot)
    {
        var heartbeat = new Heartbeat { Type = type, Autopilot = autopilot };
        rig.Send(link, Frames.Bytes(MavlinkFrame.Create(heartbeat, system, 1, sequence: 0)));
    }

    private static List<T> Decoded<T>(CommunicationsRig rig, int link)
        where T : struct, IMavlinkMessage
    {
        var messages = new List<T>();
        foreach (MavlinkFrame frame in rig.ReceivedFrames(link))
        {
            if (frame.TryDecode(out T message))
                messages.Add(message);
        }

        return messages;
    }
}
