using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>What a mission must be for a fixed wing, and when its pilot has given it over.</summary>
internal static class FixedWingRules
{
    // It loses some metres in turns (recorded: 4 m), and has nothing to stop with.
    private const double MinHeightMetres = 30;

    // Of the mission; the autopilot's own speed is flown. What flies this slowly is no fixed wing.
    private const double MinMetresPerSecond = 10;

    // It climbs with its pilot; the rest it climbs on the way to the first circle.
    private const double MaxClimbMetres = 10;

    // A circle is joined from outside, flown wider than commanded (recorded: 87 to 95 m for 80), and begins a radius
    // before the lane.
    private const double MarginInRadii = 3;

    /// <summary>Why the mission cannot be flown by a fixed wing; null where it can.</summary>
    public static string? FindFault(MissionFlight flight)
    {
        MissionPlan mission = flight.Mission;
        if (flight.Options.FixedWing is not { } options)
        {
            return "a fixed wing flies a mission with MissionControlOptions.FixedWing only (UavConsole: --fixed-wing): "
                + "its pilot takes off, gives it over in the air and lands it; it circles where it holds, revisits "
                + "nothing, and on PX4 a pilot's Hold cannot be seen";
        }

        if (mission.HeightMetres < MinHeightMetres)
        {
            return $"heightMetres is {MissionNumbers.Of(mission.HeightMetres)}; for a fixed wing it must be at least "
                + MissionNumbers.Of(MinHeightMetres);
        }

        if (mission.SpeedMetresPerSecond < MinMetresPerSecond)
        {
            return $"speedMetresPerSecond is {MissionNumbers.Of(mission.SpeedMetresPerSecond)}; for a fixed wing it "
                + $"must be at least {MissionNumbers.Of(MinMetresPerSecond)}, and the speed that the autopilot flies";
        }

        double margin = (mission.LaneSpacingMetres / 2) + (MarginInRadii * options.LoiterRadiusMetres);
        return mission.FenceMarginMetres < margin
            ? $"fenceMarginMetres is {MissionNumbers.Of(mission.FenceMarginMetres)}; for a fixed wing it must be at "
                + $"least {MissionNumbers.Of(margin)}: half a spacing and three radii of its circles"
            : null;
    }

    /// <summary>What is missing for the search to begin in the air; null where nothing is.</summary>
    public static string? FindMissing(MissionFlight flight)
    {
        if (FindNotGiven(flight) is { } notGiven)
            return notGiven;
        double height = flight.Mission.HeightMetres - MaxClimbMetres;
        if (!(flight.HeightMetres >= height))
        {
            return $"at {MissionNumbers.Of(flight.HeightMetres)} m; its pilot climbs to "
                + $"{MissionNumbers.Of(height)} m at least";
        }

        return flight.HasFreshPosition ? null : "no position";
    }

    /// <summary>Why the vehicle is not given to us; null where it is.</summary>
    public static string? FindNotGiven(MissionFlight flight)
    {
        if (FixedWings.GivenMode(flight.Vehicle.Autopilot) is not { } given)
            return $"autopilot {flight.Vehicle.Autopilot} is not commanded, only ArduPilot and PX4 are";
        return flight.Vehicle.CustomMode == given.Mode
            ? null
            : $"in {flight.Vehicle.Mode}; its pilot gives it over in {given.Name}";
    }
}
