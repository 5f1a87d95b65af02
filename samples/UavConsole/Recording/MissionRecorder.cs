using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>
/// Keeps what a person wants to see of a flight: a manager like the others, so that it sees the same at any pace. It fetches
/// five times a second and tells nobody anything, except that the mission, and so the run, is over.
/// </summary>
internal sealed class MissionRecorder : RabitManager
{
    public const string ManagerName = "recorder";

    private static readonly TimeSpan Cycle = TimeSpan.FromMilliseconds(200);
    private static readonly TimeSpan ManagerCycle = TimeSpan.FromSeconds(2);

    // After the mission the managers still have a word to say, and the last sample is taken.
    private static readonly TimeSpan Linger = TimeSpan.FromSeconds(3);

    private readonly RecorderOptions _options;
    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly MessageSubscriber<HealthReport> _health;
    private readonly MessageSubscriber<MissionStatus> _mission;
    private readonly MessageSubscriber<ImagingStatus> _imaging;
    private readonly MessageSubscriber<CommandAuthority> _authority;
    private readonly MessageSubscriber<TrackList> _tracks;
    private readonly MessageSubscriber<ManagerStatus>[] _managers;
    private readonly RecordKeeper _keeper;
    private TimeSpan _nextManagers;
    private TimeSpan? _overSince;

    /// <param name="managerNames">Those whose lives are kept; they must be in the same reactor.</param>
    /// <param name="options">Read now.</param>
    public MissionRecorder(IReadOnlyList<string> managerNames, RecorderOptions options)
        : base(ManagerName)
    {
        _options = options;
        _vehicle = Subscribe<VehicleState>(MessageNames.VehicleState);
        _health = Subscribe<HealthReport>(MessageNames.Health);
        _mission = Subscribe<MissionStatus>(MessageNames.Mission, optional: true);
        _imaging = Subscribe<ImagingStatus>(MessageNames.Imaging, optional: true);
        _authority = Subscribe<CommandAuthority>(MessageNames.CommandAuthority, optional: true);
        _tracks = Subscribe<TrackList>(MessageNames.Tracks, optional: true);
        _managers = managerNames.Select(name => SubscribeToStatus(name)).ToArray();
        _keeper = new RecordKeeper(managerNames, options.ImageChips);
        WakeUpDelay = Cycle;
    }

    /// <summary>What was kept so far. Any thread.</summary>
    public FlightRecord Record => _keeper.Snapshot();

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        TimeSpan now = Now;
        _vehicle.Fetch();
        _health.Fetch();
        _mission.Fetch();
        _imaging.Fetch();
        _authority.Fetch();
        _tracks.Fetch();
        _keeper.Take(now, _vehicle.Value, _mission.Value, _health.Value, _imaging.Value, _authority.Value, _tracks.Value ?? TrackList.None);
        if (now >= _nextManagers)
        {
            _nextManagers = now + ManagerCycle;
            for (int index = 0; index < _managers.Length; index++)
            {
                _managers[index].Fetch();
                _keeper.TakeManager(index, now, _managers[index].Value);
            }
        }

        if (_options.StopsWhenMissionEnds)
            StopWhenOver(now);
    }

    private void StopWhenOver(TimeSpan now)
    {
        bool isOver = _mission.Value.Phase switch
        {
            MissionPhase.Done => true,
            MissionPhase.Failed or MissionPhase.HandedOver => !_vehicle.Value.IsArmed,
            _ => false,
        };
        _overSince = isOver ? _overSince ?? now : null;
        if (now - _overSince >= Linger)
            StopSystem("the mission is over");
        else if (now >= _options.MaxMission)
            StopSystem($"the mission is not over after {_options.MaxMission.Value.TotalMinutes:0} minutes");
    }
}
