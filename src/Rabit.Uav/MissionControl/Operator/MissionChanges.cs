using System;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.Preflight;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// What the operator has changed of the mission and is not flown yet: values, which hold from the next leg on, and an
/// area, which the next continue takes over. What is accepted was checked as a mission file is, and planned.
/// </summary>
internal sealed class MissionChanges(MissionFlight flight)
{
    // Written by the thread of the manager; volatile for those who ask for the mission.
    private volatile MissionPlan? _next;
    private PlanJob? _nextPlan;
    private MissionPlan? _offered;
    private PlanJob? _offeredPlan;

    /// <summary>Gives a job to the planner; returns whether it takes it.</summary>
    public Func<PlanJob, bool> Planner { get; set; } = _ => false;

    /// <summary>The mission with all of it but the area that is offered. Any thread.</summary>
    public MissionPlan Mission => _next ?? flight.Mission;

    /// <summary>Whether the next leg begins with other values.</summary>
    public bool AreDue => _next is not null;

    /// <summary>Whether it begins on another plan.</summary>
    public bool NeedPlan => _nextPlan is not null;

    /// <summary>Whether the next continue takes over an area.</summary>
    public bool IsAreaOffered => _offered is not null;

    /// <summary>Begins a change; without a job it is done.</summary>
    /// <returns>Why it cannot be; null where it can.</returns>
    public string? Begin(OperatorRequest request, out PlanJob? job)
    {
        job = null;
        if (request.Command == OperatorCommand.OfferArea && request.Area.IsDefaultOrEmpty)
        {
            (_offered, _offeredPlan) = (null, null);
            return null;
        }

        if ((FindFault(request) ?? FindFault(With(request))) is { } fault)
            return fault;
        bool isPlanned = request.Command == OperatorCommand.OfferArea
            || request.Parameter == MissionParameter.LaneSpacing;
        if (!isPlanned || flight.Plan is not { } plan)
        {
            Keep(request, null);
            return null;
        }

        job = new PlanJob(
            With(request), plan.Frame.Origin, flight.IsFixedWing, flight.Options.Terrain,
            isShared: flight.Group is not null);
        return Planner(job) ? null : "the planner takes nothing";
    }

    /// <summary>Ends a change that was planned.</summary>
    /// <returns>Why it cannot be; null where it is done.</returns>
    public string? Finish(OperatorRequest request, PlanJob job)
    {
        if (job.Plan is null)
            return job.Fault;
        Keep(request, job);
        return null;
    }

    /// <summary>What follows of a change that is done, as text.</summary>
    public string TextOf(OperatorRequest request) => request.Command == OperatorCommand.ChangeParameter
        ? "from the next leg on"
        : IsAreaOffered ? "the next continue takes it over" : string.Empty;

    /// <summary>Sets the speed at once.</summary>
    public void SetSpeedNow(double metresPerSecond)
    {
        flight.ChangeMission(flight.Mission.WithSpeed(metresPerSecond));
        _next = _next?.WithSpeed(metresPerSecond);
    }

    /// <summary>Goes on over the area that is offered; where that cannot be it is offered no more.</summary>
    /// <returns>Why that cannot be; null where it is done.</returns>
    public string? TakeArea()
    {
        MissionPlan changed = Mission.WithArea(_offered!.Area, _offered.KeepOuts);
        PlanJob? job = _offeredPlan;
        (_offered, _offeredPlan) = (null, null);
        if (flight.Plan is null)
            flight.ChangeMission(changed);
        else if (Replan(changed, job) is { } fault)
            return $"new area: {fault}; the one before is kept";
        (_next, _nextPlan) = (null, null);
        flight.Log(
            $"new area of {MissionNumbers.Of(changed.Area.Length)} corners with "
            + $"{MissionNumbers.Of(changed.KeepOuts.Length)} keep-outs"
            + (flight.Route is { } route
                ? $": {MissionNumbers.Of(route.Count - route.Flown)} legs are left, "
                    + MissionNumbers.Percent(route.Coverage.Fraction) + " seen"
                : string.Empty));
        return null;
    }

    /// <summary>From here on the values hold.</summary>
    public void BeginLeg()
    {
        if (_next is not { } next)
            return;
        if (_nextPlan is { } job && flight.Plan is not null && Replan(next, job) is { } fault)
        {
            // It could be planned when it was set: only where the vehicle is has changed.
            flight.Log($"the lane spacing stays as it is: {fault}");
            next = next.With(MissionParameter.LaneSpacing, flight.Mission.LaneSpacingMetres);
        }

        flight.ChangeMission(next);
        (_next, _nextPlan) = (null, null);
    }

    // What was offered before there was a plan is planned now.
    private string? Replan(MissionPlan changed, PlanJob? job)
        => job is null
            ? flight.Replan(changed)
            : job.Plan!.FindFaultOfSpeed(changed.SpeedMetresPerSecond) ?? job.Plan.FindHeightFault(changed)
                ?? flight.Replan(changed, job.Plan, job.Route!);

    private void Keep(OperatorRequest request, PlanJob? job)
    {
        MissionPlan changed = With(request);
        if (request.Command == OperatorCommand.OfferArea)
            (_offered, _offeredPlan) = (changed, job);
        else
            (_next, _nextPlan) = (changed, job ?? _nextPlan);
    }

    private MissionPlan With(OperatorRequest request) => request.Command == OperatorCommand.OfferArea
        ? Mission.WithArea(request.Area, request.KeepOuts)
        : Mission.With(request.Parameter, request.Value);

    private string? FindFault(OperatorRequest request)
    {
        bool isOffer = request.Command == OperatorCommand.OfferArea;
        bool isPlanned = isOffer || request.Parameter == MissionParameter.LaneSpacing;
        if (isPlanned && flight.Plan is null && flight.Options.Resume is not null)
            return "there is no plan of the earlier flight yet";
        if (isOffer)
            return flight.IsFixedWing ? "the area of a fixed wing is not changed in flight" : null;
        return request.Parameter switch
        {
            MissionParameter.Height or MissionParameter.Speed or MissionParameter.LaneSpacing when flight.IsFixedWing
                => "the values of a fixed wing's legs are not changed in flight",
            MissionParameter.LaneSpacing when IsAreaOffered
                => "an area is offered: a continue takes it over, or it is withdrawn, first",
            MissionParameter.Revisits when !request.Value.Equals(0) && !request.Value.Equals(1)
                => "revisit.enabled is 0 or 1",
            MissionParameter.BatteryAtStart when flight.IsFlying => "it has taken off",
            MissionParameter.BatteryAtStart when flight.Options is { RequiresPreflight: true, Mission: { } filed }
                && request.Value < filed.MinBatteryFractionAtStart
                => $"the checklist asks for {MissionNumbers.Percent(filed.MinBatteryFractionAtStart)}, as the mission "
                    + "file",
            _ => null,
        };
    }

    private string? FindFault(MissionPlan changed)
        => MissionPlanRules.FindFaults(changed).FirstOrDefault()
            ?? flight.Options.FindsFaultOfChange?.Invoke(changed)
            ?? flight.Plan?.FindFaultOfSpeed(changed.SpeedMetresPerSecond)
            ?? flight.Plan?.FindHeightFault(changed)
            ?? FindReturnFault(changed);

    // The checklist has judged the return from the area of the start.
    private string? FindReturnFault(MissionPlan changed)
    {
        if (flight.Options.Terrain is not { } terrain || flight.Plan is not { } plan
            || ReturnHeightRule.HeightMetres(flight.Energy.Parameters) is not { } height)
            return null;
        double clearance = flight.Options.ReturnClearanceMetres;
        double highest = new ReturnTerrain(terrain, changed.Area, changed.FenceMarginMetres)
            .MaxAboveHomeMetres(plan.Frame.Origin) ?? double.NaN;
        return highest + clearance > height
            ? $"the ground is up to {MissionNumbers.Of(highest)} m above home; the autopilot returns at "
                + $"{MissionNumbers.Of(height)} m, which must be {MissionNumbers.Of(clearance)} m higher"
            : null;
    }
}
