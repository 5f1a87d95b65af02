using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

// Targets that a second vehicle validates.
internal sealed partial class MissionGroup
{
    // The flight over a target, there and back, and what is kept beside the time of the way. It takes less where the
    // target is seen.
    private const double PassSeconds = 30;
    private const double ReserveSeconds = 30;
    private const double SeenSeconds = 10;

    private TargetValidation? _validation;
    private bool _hadLanes;

    /// <summary>What of a target is looked at now; null for nothing.</summary>
    public ValidationLook? CurrentLook => _validation?.Look;

    /// <summary>A run begins.</summary>
    public void BeginRun(ushort session)
        => (_validation, _following, _links)
            = (new TargetValidation(session, Sender!, log), new FollowBook(session, Sender!, log), null);

    public void Receive(MissionFlight flight, in Envelope<ValidationTask> envelope)
    {
        _validation?.Receive(envelope.Content, SystemId, flight.Plan?.Frame, t => SecondsTo(flight, t), flight.Now);
    }

    public void Receive(MissionFlight flight, in Envelope<ValidationBid> envelope)
        => _validation?.Receive(envelope.SourceSystemId, envelope.Content, flight.Now);

    /// <summary>A picture of our own that was searched.</summary>
    public void Look(MissionFlight flight, in CameraObservation observation)
    {
        if (flight.Plan is { } plan)
            _validation?.Take(observation, plan.Frame);
        TakeOwnReports(flight, observation);
    }

    /// <summary>Whether others are there that can validate what we find, now or when they have followed.</summary>
    public bool HasOthers(MissionFlight flight) => _members.Present(flight.Now)
        .Any(m => m.Report.State is GroupMemberState.Available or GroupMemberState.Following);

    /// <summary>Whether another vehicle has validated a target, with a result.</summary>
    public bool IsValidated(MissionFlight flight, TargetTrack track)
        => flight.Plan is { } plan && _validation?.IsValidated(track, plan.Frame) == true;

    /// <summary>Whether the operator has rejected a target for the group, here or at another vehicle.</summary>
    public bool IsRejected(MissionFlight flight, TargetTrack track)
        => (flight.Plan is { } plan && _validation?.IsRejected(track, SystemId, plan.Frame) == true)
            || _links?.IsRejected(track.Id) == true;

    /// <summary>Begins with the next target that we are to validate.</summary>
    /// <returns>Which, as text; null where there is none.</returns>
    public string? NextValidation(MissionFlight flight)
    {
        if (_validation is not { } validation
            || validation.Next(flight.Position, flight.Plan!.Frame) is not { } task)
            return null;
        validation.Begin(task, flight.Plan!.Frame);
        if (RevisitPass.Plan(flight, validation.Look!.Place) is not null)
            return $"validation of {Name(task)}";
        flight.Log($"{Name(task)} cannot be seen from inside the fence");
        validation.Finish(task, ValidationResult.Unknown, flight.Now);
        return null;
    }

    /// <summary>Ends the look at a target.</summary>
    /// <returns>What it showed, as text.</returns>
    public string FinishValidation(MissionFlight flight, ValidationLook look, ValidationResult result)
    {
        _validation?.Finish(look.Task, result, flight.Now);
        return $"{Name(look.Task)}: {result.ToString().ToLowerInvariant()}, {MissionNumbers.Of(look.Reports)} reports "
            + $"in {MissionNumbers.Of(look.Pictures)} pictures";
    }

    public static string Name(in ValidationTask task)
        => $"target {MissionNumbers.Of(task.Number)} of vehicle {MissionNumbers.Of(task.Finder)}, {task.Class}";

    private void UpdateValidation(MissionFlight flight, (byte SystemId, GroupReport Report)[] present)
    {
        if (_own.State != GroupMemberState.Available)
            _validation?.DeclineAll(flight.Now);
        List<byte> able = present.Where(m => m.Report.State == GroupMemberState.Available).Select(m => m.SystemId)
            .ToList();
        _validation?.Update(flight, SystemId, able);
        foreach (TargetTrack track in _validation?.RejectedElsewhere(flight) ?? [])
            flight.OperatorActions.RejectToo(flight, track);
        bool hasLanes = flight.Route?.Current is not null;
        if (_hadLanes && !hasLanes)
            _validation?.BidForOpen(t => SecondsTo(flight, t));
        _hadLanes = hasLanes;
    }

    // Null where we cannot: not in the air, with lanes to fly from which it is too far, or with too little energy.
    private double? SecondsTo(MissionFlight flight, ValidationTask task)
    {
        if (_own.State != GroupMemberState.Available || !flight.IsFlying || flight.Plan is null)
            return null;
        if (_validation!.WasSeen(task))
            return 0;
        PlanePoint place = ValidationLook.PlaceOf(flight.Plan!.Frame, task.Position);
        if (DetourMetres(flight, place) > options.MaxValidationDetourMetres)
            return null;
        double seconds = MetresTo(flight, place) / flight.Mission.SpeedMetresPerSecond;
        EnergyStatus energy = flight.Energy.Status;
        bool isEnough = !energy.IsKnown
            || energy.TimeToReturn.ExactSeconds > seconds + PassSeconds + ReserveSeconds;
        return isEnough && RevisitPass.Plan(flight, place) is not null ? seconds : null;
    }

    // From the end of the lane that we fly to the next one, instead of straight; 0 where all are flown.
    private static double DetourMetres(MissionFlight flight, PlanePoint place)
    {
        if (flight.Route is not { Current: { } lane } route)
            return 0;
        PlanePoint next = route.Following?.Start ?? lane.End;
        return lane.End.DistanceTo(place) + place.DistanceTo(next) - lane.End.DistanceTo(next);
    }

    // By what we are to fly over before.
    private double MetresTo(MissionFlight flight, PlanePoint place)
    {
        PlanePoint from = flight.Position;
        double metres = 0;
        if (flight.Route?.Current is { } lane)
        {
            metres = lane.DistanceTo(from) + lane.Length - flight.Route.FlownMetresOfLeg;
            from = lane.End;
        }

        LocalNedFrame frame = flight.Plan!.Frame;
        IReadOnlyList<(ValidationTask Task, double Metres)> way = _validation!.WayThroughJobs(from, frame);
        if (way.Count > 0)
        {
            (ValidationTask last, double before) = way[way.Count - 1];
            metres += before + (way.Count * SeenSeconds * flight.Mission.SpeedMetresPerSecond);
            from = ValidationLook.PlaceOf(frame, last.Position);
        }

        return metres + from.DistanceTo(place);
    }
}
