using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Records a flight for the summary and the report: a manager like the others, so that it records the same at any
/// pace. Five times a second it fetches the posted messages and takes all frames out of a queue of its own; it posts
/// nothing, and it ends the run where <see cref="FlightRecorderOptions"/> asks for that.
/// </summary>
/// <remarks>
/// The frames come by <see cref="CreateSubscription"/>. No push wakes the recorder, so that it changes no other
/// manager's turn in virtual time.
/// </remarks>
/// <example>
/// <code>
/// var options = new UavOptions
/// {
///     Links = [LinkUrl.Parse("udpin:0.0.0.0:14550")],
///     Subscriptions = [FlightRecorderManager.CreateSubscription()],
/// };
/// using UavSystem uav = UavSystem.Open(options);
/// RabitReactor reactor = uav.CreateReactor(new ReactorOptions());
/// string[] names = [.. reactor.Select(m => m.Name)];
/// var recorder = new FlightRecorderManager(new FlightRecorderOptions { ManagerNames = names });
/// reactor.Add(recorder);
/// ReactorResult result = reactor.Run();
/// SummaryText.Write(Console.Out, new FlightSummary(recorder.Record, result));
/// </code>
/// </example>
public sealed class FlightRecorderManager : RabitManager
{
    /// <summary>The name of the manager.</summary>
    public const string ManagerName = "recorder";

    /// <summary>The name of the queue of <see cref="LinkFrame"/> that the recorder takes frames from.</summary>
    public const string FramesQueue = "recorder frames";

    // In one period a full Ethernet link may bring a few hundred frames; a computer that stood still for seconds
    // brings more at once.
    private const int FramesWaiting = 4096;

    private static readonly TimeSpan RecordPeriod = TimeSpan.FromMilliseconds(200);
    private static readonly TimeSpan ManagerPeriod = TimeSpan.FromSeconds(2);

    // After the mission the managers still post their last state, and the last sample is taken.
    private static readonly TimeSpan Linger = TimeSpan.FromSeconds(3);

    private readonly bool _stopsWhenMissionEnds;
    private readonly TimeSpan? _maxMissionTime;
    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly MessageSubscriber<AutopilotStatistics> _autopilot;
    private readonly MessageSubscriber<HealthReport> _health;
    private readonly MessageSubscriber<MissionStatus> _mission;
    private readonly MessageSubscriber<ImagingStatus> _imaging;
    private readonly MessageSubscriber<CommandAuthority> _authority;
    private readonly MessageSubscriber<TrackList> _tracks;
    private readonly MessageSubscriber<GroupStatus> _group;
    private readonly MessageSubscriber<ManagerStatus>[] _managers;
    private readonly QueueReceiver<LinkFrame> _frames;
    private readonly RecordKeeper _keeper;
    private TimeSpan _nextManagers;
    private TimeSpan? _overSince;

    /// <summary>Makes the recorder; add it to the reactor after the managers that it records.</summary>
    /// <param name="options">Read now; later changes have no effect.</param>
    public FlightRecorderManager(FlightRecorderOptions options)
        : base(ManagerName)
    {
        if (options is null)
            throw new ArgumentNullException(nameof(options));
        _stopsWhenMissionEnds = options.StopsWhenMissionEnds;
        _maxMissionTime = options.MaxMissionTime;
        _vehicle = Subscribe<VehicleState>(MessageNames.VehicleState);
        _autopilot = Subscribe<AutopilotStatistics>(MessageNames.AutopilotStatistics, optional: true);
        _health = Subscribe<HealthReport>(MessageNames.Health);
        _mission = Subscribe<MissionStatus>(MessageNames.Mission, optional: true);
        _imaging = Subscribe<ImagingStatus>(MessageNames.Imaging, optional: true);
        _authority = Subscribe<CommandAuthority>(MessageNames.CommandAuthority, optional: true);
        _tracks = Subscribe<TrackList>(MessageNames.Tracks, optional: true);
        _group = Subscribe<GroupStatus>(MessageNames.Group, optional: true);
        _frames = Receive<LinkFrame>(FramesQueue, FramesWaiting, QueueFullMode.Reject, wakeOnPush: false);
        string[] managers = options.ManagerNames.ToArray();
        _managers = managers.Select(name => SubscribeToStatus(name)).ToArray();
        _keeper = new RecordKeeper(managers, options.ImageChips ?? (() => []), options.FindPictureOverview);
        WakeUpDelay = RecordPeriod;
    }

    /// <summary>What was recorded so far; a new snapshot at each call. Any thread.</summary>
    public FlightRecord Record => _keeper.Snapshot();

    /// <summary>
    /// The subscription that brings the recorder its frames, of all messages: for
    /// <see cref="UavOptions.Subscriptions"/>.
    /// </summary>
    public static MavlinkSubscription CreateSubscription() => new(FramesQueue);

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        TimeSpan now = Now;
        TakeFrames();
        _health.Fetch();
        _mission.Fetch();
        _imaging.Fetch();
        _authority.Fetch();
        _tracks.Fetch();
        _group.Fetch();
        _keeper.Take(
            now, _vehicle.Value, _mission.Value, _health.Value, _imaging.Value, _authority.Value,
            _tracks.Value ?? TrackList.None, _group.Value);
        if (now >= _nextManagers)
        {
            _nextManagers = now + ManagerPeriod;
            for (int index = 0; index < _managers.Length; index++)
            {
                _managers[index].Fetch();
                _keeper.TakeManager(index, now, _managers[index].Value);
            }
        }

        if (_stopsWhenMissionEnds)
            StopWhenOver(now);
    }

    /// <summary>Takes the frames that came since the last unit of work: a replay ends with its last frame.</summary>
    protected override void Shutdown() => TakeFrames();

    // The address of the autopilot first: it says whose frames are the vehicle's.
    private void TakeFrames()
    {
        _vehicle.Fetch();
        _autopilot.Fetch();
        _keeper.TakeFrames(_frames, _vehicle.Value, _autopilot.Value);
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
        else if (now >= _maxMissionTime)
            StopSystem($"the mission is not over after {_maxMissionTime.Value.TotalMinutes:0} minutes");
    }
}
