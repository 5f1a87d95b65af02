using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

// Targets that a second vehicle validates.
internal sealed partial class MissionGroup
{
    // The flight over a target, there and back, and what is kept beside the time of the way.
    private const double PassSeconds = 30;
    private const double ReserveSeconds = 30;

    private TargetValidation? _validation;

    /// <summary>What of a target is looked at now; null for nothing.</summary>
    public ValidationLook? CurrentLook => _validation?.Look;

    /// <summary>A run begins.</summary>
    public void BeginRun(ushort session)
        => (_validation, _following, _links)
            = (new TargetValidation(session, Sender!, log), new FollowBook(session, Sender!, log), null);

    public void Receive(MissionFlight flight, in Envelope<ValidationTask> envelope)
    {
        if (flight.Plan is not null)
            _validation?.Receive(envelope.Content, SystemId, t => SecondsTo(flight, t), flight.Now);
    }

    public void Receive(MissionFlight flight, in Envelope<ValidationBid> envelope)
        => _validation?.Receive(envelope.SourceSystemId, envelope.Content, flight.Now);

    /// <summary>A picture of our own that was searched.</summary>
    public void Look(MissionFlight flight, in CameraObservation observation)
    {
        _validation?.Look?.Take(observation);
        TakeOwnReports(flight, observation);
    }

    /// <summary>Whether others are there that can validate what we find, now or when they have followed.</summary>
    public bool HasOthers(MissionFlight flight) => _members.Present(flight.Now)
        .Any(m => m.Report.State is GroupMemberState.Available or GroupMemberState.Following);

    /// <summary>Whether another vehicle has validated a target, with a result.</summary>
    public bool IsValidated(MissionFlight flight, TargetTrack track)
        => flight.Plan is { } plan && _validation?.IsValidated(track, plan.Frame) == true;

    /// <summary>Begins with the next target that we are to validate.</summary>
    /// <returns>Which, as text; null where there is none.</returns>
    public string? NextValidation(MissionFlight flight)
    {
        if (_validation is not { Next: { } task } validation)
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
    }

    // Null where we cannot: not in the air, or with too little energy.
    private double? SecondsTo(MissionFlight flight, ValidationTask task)
    {
        if (_own.State != GroupMemberState.Available || !flight.IsFlying)
            return null;
        PlanePoint place = ValidationLook.PlaceOf(flight.Plan!.Frame, task.Position);
        double seconds = (flight.Position.DistanceTo(place) / flight.Mission.SpeedMetresPerSecond)
            + (PassSeconds * _validation!.Waiting);
        EnergyStatus energy = flight.Energy.Status;
        bool isEnough = !energy.IsKnown
            || energy.TimeToReturn.TotalSeconds > seconds + PassSeconds + ReserveSeconds;
        return isEnough && RevisitPass.Plan(flight, place) is not null ? seconds : null;
    }
}
