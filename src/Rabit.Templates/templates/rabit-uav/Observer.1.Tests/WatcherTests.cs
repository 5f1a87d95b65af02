using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav;
using Rabit.Uav.Messages;
using Xunit;

namespace Observer._1.Tests;

/// <summary>Only the manager under test is in the reactor; the test plays the six managers.</summary>
public sealed class WatcherTests
{
    private readonly List<string> _lines = [];
    private readonly RabitReactor _reactor = new(new VirtualTime(seed: 1));
    private readonly MessagePublisher<VehicleState> _vehicle;
    private readonly MessagePublisher<HealthReport> _health;
    private readonly MessagePublisher<TrackList> _tracks;

    public WatcherTests()
    {
        _reactor.Add(new Watcher(_lines.Add));
        _vehicle = _reactor.Workspace.Publish<VehicleState>(MessageNames.VehicleState);
        _health = _reactor.Workspace.Publish<HealthReport>(MessageNames.Health);
        _tracks = _reactor.Workspace.Publish(MessageNames.Tracks, TrackList.None);
        _reactor.Start();
    }

    [Fact]
    public void Vehicle_NotConnected_IsSaidEveryTenSeconds()
    {
        _reactor.RunFor(TimeSpan.FromSeconds(15));   // virtual: no time passes

        Assert.Equal(2, _lines.Count);   // at 0 s and at 10 s
        Assert.Equal("    10 s  no heartbeat of an autopilot received yet", _lines[1]);
    }

    [Fact]
    public void Vehicle_Connected_IsDescribed()
    {
        _vehicle.Value.Autopilot = MavAutopilot.Px4;
        _vehicle.Value.Mode = "AUTO.LOITER";
        _vehicle.Value.IsArmed = true;
        _vehicle.Value.HeightAboveHomeMetres = 30.2;
        _vehicle.Value.BatteryRemaining = 0.75;
        _vehicle.Post();
        _health.Value.Level = HealthLevel.Warning;
        _health.Post();
        _reactor.RunFor(TimeSpan.FromSeconds(1));

        Assert.Equal(
            "     0 s  Px4 AUTO.LOITER armed, 30.2 m high, battery 75 %, health Warning", Assert.Single(_lines));
    }

    [Fact]
    public void Target_Confirmed_IsReportedOnce()
    {
        _reactor.RunFor(TimeSpan.FromSeconds(1));
        Post(TrackState.Tentative);
        Post(TrackState.Confirmed);
        Post(TrackState.Confirmed);

        Assert.Single(_lines, line => line.Contains("target 3: raft at ", StringComparison.Ordinal));
    }

    private void Post(TrackState state)
    {
        var raft = new TargetTrack
        {
            Id = 3,
            State = state,
            Class = RaftDetector.Raft.Name,
            Position = GeodeticPosition.FromDegrees(47.3975, 8.545, 488),
            SizeMetres = 1,
        };
        _tracks.Value = new TrackList(_reactor.Now, [raft]);
        _tracks.Post();
        _reactor.RunFor(TimeSpan.FromSeconds(1));
    }
}
