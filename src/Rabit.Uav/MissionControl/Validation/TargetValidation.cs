using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The validation of targets by a second vehicle: what we found is announced to the others, and what they found is
/// flown over where it is awarded to us. Where two vehicles announce one target, one of the tasks is kept. One thread.
/// </summary>
internal sealed class TargetValidation(ushort session, IValidationSender sender, Action<string> log)
{
    // Beside the uncertainties that both tasks state.
    private const double SameMetres = 3;

    private readonly ValidationFinder _finder = new(session, sender, log);
    private readonly ValidationBidder _bidder = new(sender);
    private readonly List<TargetTrack> _own = [];
    private readonly Dictionary<(byte Finder, ushort Session, ushort Number), ValidationLook> _inPassing = [];

    /// <summary>Messages that were refused.</summary>
    public long Refused => _finder.Refused + _bidder.Refused;

    /// <summary>All tasks that are known, ours with our system id; those of the same target are all there.</summary>
    public IEnumerable<ValidationTask> TasksOf(byte ownSystemId)
        => _finder.Tasks.Select(t => t with { Finder = ownSystemId }).Concat(_bidder.Tasks);

    /// <summary>Whether a target is not validated yet, ours or another vehicle's.</summary>
    public bool IsPending => _finder.IsPending || _bidder.Tasks.Any(t => t.State != ValidationState.Closed);

    /// <summary>What is to be flown over now; null while there is nothing, and while it is flown over.</summary>
    /// <param name="from">Where we are: the nearest one comes first.</param>
    /// <param name="frame">Of the plan.</param>
    public ValidationTask? Next(PlanePoint from, LocalNedFrame frame)
        => Look is null && WayThroughJobs(from, frame) is { Count: > 0 } way ? way[0].Task : null;

    /// <summary>What is to be flown over, each time the nearest next, and how far it is to there.</summary>
    public IReadOnlyList<(ValidationTask Task, double Metres)> WayThroughJobs(PlanePoint from, LocalNedFrame frame)
    {
        var left = _bidder.Jobs.Select(t => (Task: t, Place: ValidationLook.PlaceOf(frame, t.Position))).ToList();
        var way = new List<(ValidationTask Task, double Metres)>();
        double metres = 0;
        while (left.Count > 0)
        {
            (ValidationTask task, PlanePoint place) = left.OrderBy(j => j.Place.DistanceTo(from)).First();
            left.RemoveAll(j => ValidationBidder.KeyOf(j.Task) == ValidationBidder.KeyOf(task));
            metres += from.DistanceTo(place);
            way.Add((task, metres));
            from = place;
        }

        return way;
    }

    /// <summary>We can fly now: bids for all that is open.</summary>
    public void BidForOpen(Func<ValidationTask, double?> secondsTo) => _bidder.BidForOpen(secondsTo);

    /// <summary>What is flown over; null for nothing.</summary>
    public ValidationLook? Look { get; private set; }

    /// <summary>Whether a track of ours was validated, with a result.</summary>
    public bool IsValidated(TargetTrack track, LocalNedFrame frame)
        => _finder.Find(track.Id) is { State: ValidationState.Closed, Result: not ValidationResult.Unknown }
            || _bidder.Tasks.Any(
                t => t.State == ValidationState.Closed && t.Result != ValidationResult.Unknown
                    && AreSame(TaskOf(track), t, frame));

    /// <summary>Whether the operator has rejected a target, here or at another vehicle.</summary>
    public bool IsRejected(TargetTrack track, byte ownSystemId, LocalNedFrame frame)
        => TasksOf(ownSystemId).Any(t => t.IsRejectedByOperator && AreSame(TaskOf(track), t, frame));

    /// <summary>
    /// Our tracks of what the operator of another vehicle has rejected: of each target the nearest one of its class.
    /// </summary>
    public IEnumerable<TargetTrack> RejectedElsewhere(MissionFlight flight) => _bidder.Tasks
        .Where(t => t.IsRejectedByOperator).Select(t => NearestTrack(flight, t)).OfType<TargetTrack>();

    /// <summary>Takes the state of a task of another vehicle.</summary>
    /// <param name="task">As its finder sent it.</param>
    /// <param name="ownSystemId">Ours.</param>
    /// <param name="frame">Of the plan; null before there is one.</param>
    /// <param name="secondsTo">After what time we would be there; null where we cannot.</param>
    /// <param name="now">The time.</param>
    public void Receive(
        in ValidationTask task, byte ownSystemId, LocalNedFrame? frame, Func<ValidationTask, double?> secondsTo,
        TimeSpan now)
    {
        _bidder.Receive(task, ownSystemId, secondsTo, now);
        if (task.State != ValidationState.Open || frame is not { } known)
            return;

        // Who came late does not know what was validated before.
        foreach (ValidationTask own in _finder.Tasks)
        {
            bool isValidated = own.State == ValidationState.Closed && own.Result != ValidationResult.Unknown;
            if (isValidated && AreSame(own, task, known))
                _finder.SendSoon(own.Number, now);
        }
    }

    public void Receive(byte source, in ValidationBid bid, TimeSpan now) => _finder.Receive(source, bid, now);

    /// <summary>In each tick.</summary>
    /// <param name="flight">The state of the mission; with a plan.</param>
    /// <param name="ownSystemId">Ours.</param>
    /// <param name="present">The system ids of the others that can validate.</param>
    public void Update(MissionFlight flight, byte ownSystemId, IReadOnlyCollection<byte> present)
    {
        LocalNedFrame frame = flight.Plan!.Frame;
        _own.Clear();
        foreach (TargetTrack track in flight.Tracks.Tracks)
        {
            // A picture of our own; a track of another vehicle's reports alone is that vehicle's to announce.
            bool isOurs = track.State == TrackState.Confirmed && track.BestPictureNumber >= 0
                && track.Motion == TargetMotion.Standing && flight.Mission.IsTarget(track.Class);
            if (isOurs)
                _own.Add(track);
        }

        EndRejected(flight, ownSystemId);
        foreach (TargetTrack track in _own)
        {
            ValidationTask target = TaskOf(track);
            if (_bidder.Tasks.Any(t => IsInstead(t, ownSystemId) && AreSame(target, t, frame)))
                _finder.Withdraw(track.Id, flight.Now);
            else if (_finder.Find(track.Id) is null
                && !_bidder.Tasks.Any(t => IsKept(t) && AreSame(target, t, frame)))
                _finder.Announce(track.Id, target);
        }

        FinishSeen(flight.Now);
        _finder.Update(present, flight.Now);
        _bidder.Update(flight.Now);
        if (Look is { } look && !_bidder.IsOurs(look.Task))
            Look = null;
    }

    /// <summary>A picture of our own that was searched: it may show targets of others beside the lane we fly.</summary>
    public void Take(in CameraObservation observation, LocalNedFrame frame)
    {
        Look?.Take(observation);
        foreach (ValidationTask task in _bidder.Tasks)
        {
            if (task.State == ValidationState.Closed)
                _inPassing.Remove(ValidationBidder.KeyOf(task));
            else
                LookInPassing(task, frame).Take(observation);
        }
    }

    /// <summary>Whether our pictures have shown a target often enough to confirm it, on our way.</summary>
    public bool WasSeen(in ValidationTask task)
        => _inPassing.TryGetValue(ValidationBidder.KeyOf(task), out ValidationLook? look) && look.IsEnough;

    /// <summary>Begins to look at the next one.</summary>
    public void Begin(ValidationTask task, LocalNedFrame frame) => Look = new ValidationLook(task, frame);

    /// <summary>Ends the look.</summary>
    public void Finish(ValidationTask task, ValidationResult result, TimeSpan now)
    {
        _bidder.Finish(task, result, now);
        Look = null;
    }

    /// <summary>We cannot fly over anything any more.</summary>
    public void DeclineAll(TimeSpan now)
    {
        _bidder.DeclineAll(now);
        Look = null;
    }

    // Also what another vehicle announced; who found the same target ends its own task then.
    private void EndRejected(MissionFlight flight, byte ownSystemId)
    {
        TargetTrack[] elsewhere = RejectedElsewhere(flight).ToArray();
        foreach (TargetTrack track in flight.Tracks.Tracks)
        {
            bool isElsewhere = elsewhere.Contains(track);
            bool isRejected = track.Motion == TargetMotion.Standing
                && (track.Decision == TargetDecision.Rejected
                    || (isElsewhere && track.Decision == TargetDecision.None));
            bool isAnnounced = _finder.Find(track.Id) is not null;
            if (isRejected && (isAnnounced || !isElsewhere))
                _finder.Reject(track.Id, TaskOf(track), ownSystemId, flight.Now);
        }
    }

    private static TargetTrack? NearestTrack(MissionFlight flight, ValidationTask task)
    {
        LocalNedFrame frame = flight.Plan!.Frame;
        return flight.Tracks.Tracks
            .Where(t => t.Motion == TargetMotion.Standing && AreSame(TaskOf(t), task, frame))
            .OrderBy(t => ValidationLook.PlaceOf(frame, t.Position)
                .DistanceTo(ValidationLook.PlaceOf(frame, task.Position)))
            .FirstOrDefault();
    }

    private ValidationLook LookInPassing(in ValidationTask task, LocalNedFrame frame)
    {
        (byte, ushort, ushort) key = ValidationBidder.KeyOf(task);
        if (!_inPassing.TryGetValue(key, out ValidationLook? look))
            _inPassing[key] = look = new ValidationLook(task, frame);
        return look;
    }

    // What is flown over now ends by its own look.
    private void FinishSeen(TimeSpan now)
    {
        ValidationTask[] seen = _bidder.Tasks.Where(t => _bidder.IsOurs(t) && WasSeen(t)).ToArray();
        foreach (ValidationTask task in seen)
        {
            if (Look is { } look && ValidationBidder.KeyOf(look.Task) == ValidationBidder.KeyOf(task))
                continue;
            log($"{MissionGroup.Name(task)}: confirmed in passing");
            _bidder.Finish(task, ValidationResult.Confirmed, now);
        }
    }

    // A task that was withdrawn has no result.
    private static bool IsKept(in ValidationTask task)
        => task.State != ValidationState.Closed || task.Result != ValidationResult.Unknown;

    // Who is further keeps it, then who has the lower system id.
    private static bool IsInstead(in ValidationTask task, byte ownSystemId)
        => IsKept(task) && (task.State != ValidationState.Open || task.Finder < ownSystemId);

    private static ValidationTask TaskOf(TargetTrack track) => new()
    {
        Class = track.Class,
        MarkerId = track.MarkerId,
        Position = track.Position,
        RadiusMetres = track.Covariance.HalfMajorAxis95Metres,
    };

    private static bool AreSame(in ValidationTask a, in ValidationTask b, LocalNedFrame frame)
        => a.Class == b.Class && a.MarkerId == b.MarkerId
            && ValidationLook.PlaceOf(frame, a.Position).DistanceTo(ValidationLook.PlaceOf(frame, b.Position))
                <= a.RadiusMetres + b.RadiusMetres + SameMetres;
}
