using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// What the operator has changed of the mission and is not flown yet: values, which hold from the next leg on, and an
/// area, which the next continue takes over. What is accepted was checked as a mission file is, and planned once.
/// </summary>
internal sealed class MissionChanges(MissionFlight flight)
{
    // Written by the thread of the manager; volatile for those who ask for the mission.
    private volatile MissionPlan? _next;
    private MissionPlan? _offered;

    /// <summary>The mission with all of it but the area that is offered. Any thread.</summary>
    public MissionPlan Mission => _next ?? flight.Mission;

    /// <summary>Whether the next leg begins with other values.</summary>
    public bool AreDue => _next is not null;

    /// <summary>Whether what is left is planned again then.</summary>
    public bool NeedPlan
        => _next is { } next && flight.Plan is not null
            && !next.LaneSpacingMetres.Equals(flight.Mission.LaneSpacingMetres);

    /// <summary>Whether the next continue takes over an area.</summary>
    public bool IsAreaOffered => _offered is not null;

    /// <summary>Sets a value.</summary>
    /// <returns>Why that cannot be; null where it is done.</returns>
    public string? Set(MissionParameter parameter, double value)
    {
        if (FindFault(parameter, value) is { } fault)
            return fault;
        MissionPlan changed = Mission.With(parameter, value);
        fault = FindFault(changed, isPlanned: parameter == MissionParameter.LaneSpacing);
        if (fault is null)
            _next = changed;
        return fault;
    }

    /// <summary>Sets the speed at once.</summary>
    public void SetSpeedNow(double metresPerSecond)
    {
        flight.ChangeMission(flight.Mission.WithSpeed(metresPerSecond));
        _next = _next?.WithSpeed(metresPerSecond);
    }

    /// <summary>Offers an area; one without corners withdraws what was offered.</summary>
    /// <returns>Why it cannot be searched; null where it can.</returns>
    public string? Offer(
        ImmutableArray<GeodeticPosition> area, ImmutableArray<ImmutableArray<GeodeticPosition>> keepOuts)
    {
        if (area.IsDefaultOrEmpty)
        {
            _offered = null;
            return null;
        }

        string? fault = FindFaultOfArea(area, keepOuts);
        if (fault is null)
            _offered = Mission.WithArea(area, keepOuts);
        return fault;
    }

    /// <summary>Why an area cannot be searched; null where it can. Any thread: what it reads does not change.</summary>
    public string? FindFaultOfArea(
        ImmutableArray<GeodeticPosition> area, ImmutableArray<ImmutableArray<GeodeticPosition>> keepOuts)
        => flight.IsFixedWing ? "the area of a fixed wing is not changed in flight"
            : flight.Plan is null && flight.Options.Resume is not null ? "there is no plan of the earlier flight yet"
            : FindFault(Mission.WithArea(area, keepOuts), isPlanned: true);

    /// <summary>Goes on over the area that is offered; where that cannot be it is offered no more.</summary>
    /// <returns>Why that cannot be; null where it is done.</returns>
    public string? TakeArea()
    {
        MissionPlan changed = Mission.WithArea(_offered!.Area, _offered.KeepOuts);
        _offered = null;
        if (flight.Plan is null)
            flight.ChangeMission(changed);
        else if (flight.Replan(changed) is { } fault)
            return $"new area: {fault}; the one before is kept";
        _next = null;
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
        if (NeedPlan && flight.Replan(next) is { } fault)
        {
            // It could be planned when it was set: only where the vehicle is has changed.
            flight.Log($"the lane spacing stays as it is: {fault}");
            next = next.With(MissionParameter.LaneSpacing, flight.Mission.LaneSpacingMetres);
        }

        flight.ChangeMission(next);
        _next = null;
    }

    private string? FindFault(MissionParameter parameter, double value) => parameter switch
    {
        MissionParameter.Height or MissionParameter.Speed or MissionParameter.LaneSpacing when flight.IsFixedWing
            => "the values of a fixed wing's legs are not changed in flight",
        MissionParameter.Revisits when !value.Equals(0) && !value.Equals(1) => "revisit.enabled is 0 or 1",
        MissionParameter.BatteryAtStart when flight.IsFlying => "it has taken off",
        MissionParameter.BatteryAtStart when flight.Options is { RequiresPreflight: true, Mission: { } filed }
            && value < filed.MinBatteryFractionAtStart
            => $"the checklist asks for {MissionNumbers.Percent(filed.MinBatteryFractionAtStart)}, as the mission file",
        MissionParameter.LaneSpacing when flight.Plan is null && flight.Options.Resume is not null
            => "there is no plan of the earlier flight yet",
        _ => null,
    };

    private string? FindFault(MissionPlan changed, bool isPlanned)
    {
        if (MissionPlanRules.FindFaults(changed).FirstOrDefault() is { } wrong)
            return wrong;
        if (flight.Options.FindsFaultOfChange?.Invoke(changed) is { } other)
            return other;
        if (!isPlanned || flight.Plan is not { } plan)
            return null;
        return FlightPlan.Create(changed, plan.Frame.Origin, out string fault, isFixedWing: flight.IsFixedWing) is null
            ? fault
            : null;
    }
}
