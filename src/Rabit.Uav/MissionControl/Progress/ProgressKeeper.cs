using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Hands the progress of a mission to the writer of its file: at each change of the phase or of the command authority,
/// after each lane, and every few seconds. Nothing is allocated in between; while the disk is slow the next one waits.
/// </summary>
internal sealed class ProgressKeeper(
    MissionFlight flight, ProgressFileTarget target, BlockingWriter<ProgressSnapshot> writer)
{
    /// <summary>As many as there are snapshots: a push is never rejected.</summary>
    public const int Snapshots = 2;

    private static readonly TimeSpan Period = TimeSpan.FromSeconds(5);

    private readonly ProgressSnapshot[] _snapshots = [new ProgressSnapshot(), new ProgressSnapshot()];
    private readonly MissionPlan _filed = flight.Options.Mission ?? flight.Mission;
    private readonly string _fingerprint = MissionFingerprint.Of(flight.Options.Mission ?? flight.Mission);
    private (MissionPhase Phase, bool IsCommanding, bool IsInAir, int Lanes) _last;
    private TimeSpan? _lastTime;
    private string? _lastFault;
    private MissionPlan? _flown;
    private ProgressChanges _changes = ProgressChanges.None;

    /// <summary>At the end of each unit of work, once there is a plan.</summary>
    /// <param name="phase">The phase.</param>
    /// <param name="hasStopped">Whether the program stops in order: then it commands no more.</param>
    /// <param name="utc">The time of day.</param>
    public void Update(MissionPhase phase, bool hasStopped, DateTimeOffset utc)
    {
        LogFault();
        if (flight.Plan is null || flight.Route is null)
            return;
        (MissionPhase, bool, bool, int) now = (
            phase,
            flight.Authority.State == CommandAuthorityState.Ours && phase != MissionPhase.HandedOver && !hasStopped,
            flight.IsFlying, flight.Route.Flown);
        if (now == _last && flight.Now - _lastTime < Period)
            return;
        ProgressSnapshot? free = Array.Find(_snapshots, s => s.IsFree);
        if (free is null)
            return;
        (_last, _lastTime) = (now, flight.Now);
        free.IsFree = false;
        Fill(free, utc);
        if (writer.Push(free) == PushResult.Rejected)
            free.IsFree = true;
    }

    private void Fill(ProgressSnapshot snapshot, DateTimeOffset utc)
    {
        SearchRoute route = flight.Route!;
        (snapshot.MissionName, snapshot.Fingerprint) = (flight.Mission.Name, _fingerprint);
        (snapshot.Phase, snapshot.IsCommanding, snapshot.IsInAir, snapshot.LanesFlown) = _last;
        snapshot.SavedUtc = utc;
        snapshot.Home = flight.Plan!.Frame.Origin;
        snapshot.Legs = route.Legs;
        snapshot.FlownMetresOfLeg = route.FlownMetresOfLeg;
        snapshot.Skipped = route.SkippedLanes;
        snapshot.GapPasses = route.GapPasses;
        if (!ReferenceEquals(_flown, flight.Mission))
            (_flown, _changes) = (flight.Mission, ProgressChanges.Of(_filed, flight.Mission));
        snapshot.Changes = _changes;
        snapshot.Coverage = route.Coverage.Fraction;
        snapshot.Cells = route.Coverage.ToCells(snapshot.Cells);
        snapshot.Tracks = flight.Tracks;
        snapshot.Revisited = flight.Revisits.Finished;
        snapshot.Earlier = flight.Options.Resume?.Targets ?? [];
        snapshot.EarlierRejected = flight.Options.Resume?.RejectedTargets ?? [];
    }

    // Once for each fault, and when it is over.
    private void LogFault()
    {
        if (target.Fault == _lastFault)
            return;
        _lastFault = target.Fault;
        flight.Log(_lastFault is null ? "progress file written again" : "progress file not written: " + _lastFault);
    }
}
