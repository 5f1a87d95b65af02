using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Channels;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Web.Collecting;

/// <summary>
/// Fetches what the managers post, five times a second by the clock of the run, and hands it to the page, which has
/// threads of its own: nothing that a browser does reaches a manager but the operator's commands. What the page does
/// not take in time is dropped, the oldest first, and counted.
/// </summary>
internal sealed class LivePageManager : RabitManager
{
    /// <summary>The name of the manager.</summary>
    public const string ManagerName = "live page";

    /// <summary>The queue of the positions of other vehicles.</summary>
    public const string PositionsQueue = "live page positions";

    // At the greatest pace of a simulation a few hundred pass between two turns of the page.
    private const int MomentsWaiting = 1024;
    private const int PositionsWaiting = 64;

    private static readonly TimeSpan FetchPeriod = TimeSpan.FromMilliseconds(200);
    private static readonly TimeSpan StatusPeriod = TimeSpan.FromSeconds(1);

    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly MessageSubscriber<MissionStatus> _mission;
    private readonly MessageSubscriber<HealthReport> _health;
    private readonly MessageSubscriber<ImagingStatus> _imaging;
    private readonly MessageSubscriber<TrackList> _tracks;
    private readonly MessageSubscriber<RecentItems<StatusText>> _texts;
    private readonly MessageSubscriber<LinkStatus>[] _links;
    private readonly MessageSubscriber<ManagerStatus>[] _managers;
    private readonly OtherVehicles? _others;
    private readonly Channel<FlightMoment> _moments;
    private IReadOnlyList<LinkStatus> _linkStatus = [];
    private IReadOnlyList<ManagerMoment> _managerStatus = [];
    private TimeSpan _nextStatus;
    private long _dropped;

    /// <param name="managerNames">The managers that are shown, all in the same reactor.</param>
    /// <param name="linkCount">How many links Communications has.</param>
    /// <param name="hearsOthers">Whether the queue of positions is fed.</param>
    public LivePageManager(IReadOnlyList<string> managerNames, int linkCount, bool hearsOthers)
        : base(ManagerName)
    {
        _vehicle = Subscribe<VehicleState>(MessageNames.VehicleState, optional: true);
        _mission = Subscribe<MissionStatus>(MessageNames.Mission, optional: true);
        _health = Subscribe<HealthReport>(MessageNames.Health, optional: true);
        _imaging = Subscribe<ImagingStatus>(MessageNames.Imaging, optional: true);
        _tracks = Subscribe<TrackList>(MessageNames.Tracks, optional: true);
        _texts = Subscribe<RecentItems<StatusText>>(MessageNames.StatusTexts, optional: true);
        _links =
        [
            .. Enumerable.Range(0, linkCount)
                .Select(n => Subscribe<LinkStatus>(MessageNames.LinkStatus(n), optional: true)),
        ];
        _managers = [.. managerNames.Select(name => SubscribeToStatus(name))];
        if (hearsOthers)
            _others = new OtherVehicles(new MavlinkMessageReceiver<GlobalPositionInt>(
                Receive<LinkFrame>(PositionsQueue, PositionsWaiting, QueueFullMode.DropOldest, wakeOnPush: false)));
        _moments = Channel.CreateBounded<FlightMoment>(
            new BoundedChannelOptions(MomentsWaiting) { FullMode = BoundedChannelFullMode.DropOldest },
            _ => Interlocked.Increment(ref _dropped));
        WakeUpDelay = FetchPeriod;

        // A page that fails is no reason to end a flight.
        FaultPolicy = FaultPolicy.CarryOn;
    }

    /// <summary>What was fetched, oldest first. Read by the page.</summary>
    public ChannelReader<FlightMoment> Moments => _moments.Reader;

    /// <summary>How many were dropped.</summary>
    public long Dropped => Interlocked.Read(ref _dropped);

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork() => Take();

    /// <inheritdoc/>
    protected override void Shutdown() => Take();

    private void Take()
    {
        TimeSpan now = Now;
        _vehicle.Fetch();
        _mission.Fetch();
        _health.Fetch();
        _imaging.Fetch();
        _tracks.Fetch();
        _texts.Fetch();
        if (now >= _nextStatus)
        {
            _nextStatus = now + StatusPeriod;
            _linkStatus = [.. _links.Select(Latest)];
            _managerStatus = [.. _managers.Select(m => new ManagerMoment(TimeOf(m), m.Value))];
        }

        _moments.Writer.TryWrite(new FlightMoment
        {
            Time = now,
            Vehicle = _vehicle.Value,
            Mission = _mission.Value,
            Health = _health.Value,
            Imaging = _imaging.Value,
            Tracks = _tracks.Value ?? TrackList.None,
            Texts = _texts.Value ?? RecentItems<StatusText>.None,
            Links = _linkStatus,
            Managers = _managerStatus,
            Others = _others?.Take(now, _vehicle.Value.SystemId) ?? [],
        });
    }

    private static TimeSpan TimeOf(MessageSubscriber<ManagerStatus> manager)
    {
        manager.Fetch();
        return manager.Stamp.Time;
    }

    private static T Latest<T>(MessageSubscriber<T> subscriber)
    {
        subscriber.Fetch();
        return subscriber.Value;
    }
}
