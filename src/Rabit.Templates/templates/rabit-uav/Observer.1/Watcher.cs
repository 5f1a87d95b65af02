using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav;
using Rabit.Uav.Messages;

namespace Observer._1;

/// <summary>
/// A manager beside the six of Rabit.Uav: it subscribes to what they post (<see cref="MessageNames"/> has the names),
/// and prints a line every ten seconds and one for each target that is confirmed.
/// </summary>
public sealed class Watcher : RabitManager
{
    private static readonly TimeSpan LinePeriod = TimeSpan.FromSeconds(10);

    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly MessageSubscriber<HealthReport> _health;
    private readonly MessageSubscriber<TrackList> _tracks;
    private readonly HashSet<int> _reported = [];
    private readonly Action<string> _print;
    private TimeSpan _nextLine;

    // The constructor only says what the manager publishes, subscribes to, sends and receives.
    public Watcher(Action<string> print)
        : base("watcher")
    {
        _vehicle = Subscribe<VehicleState>(MessageNames.VehicleState);
        _health = Subscribe<HealthReport>(MessageNames.Health);
        _tracks = Subscribe<TrackList>(MessageNames.Tracks, wakeOnPost: true);
        _print = print;
        Period = LinePeriod;
    }

    // Every ten seconds, and whenever tracks are posted.
    protected override void ExecuteUnitOfWork()
    {
        if (_tracks.Fetch())
            ReportTargets(_tracks.Value);
        if (Now < _nextLine)
            return;
        _nextLine = Now + LinePeriod;
        ReportVehicle();
    }

    private void ReportTargets(TrackList tracks)
    {
        foreach (TargetTrack track in tracks.Confirmed)
        {
            if (_reported.Add(track.Id))
                Print($"target {track.Id}: {track.Class} at {track.Position}, {track.SizeMetres:0.0} m wide");
        }
    }

    private void ReportVehicle()
    {
        _vehicle.Fetch();
        _health.Fetch();
        VehicleState vehicle = _vehicle.Value;
        if (vehicle.Mode is null)
            Print($"no heartbeat of an autopilot received yet");
        else
            Print($"{vehicle.Autopilot} {vehicle.Mode} {(vehicle.IsArmed ? "armed" : "disarmed")}, {Math.Max(0, vehicle.HeightAboveHomeMetres):0.0} m high, battery {vehicle.BatteryRemaining:P0}, health {_health.Value.Level}");
    }

    private void Print(FormattableString line)
        => _print(FormattableString.Invariant($"{Now.TotalSeconds,6:0} s  ") + FormattableString.Invariant(line));
}
