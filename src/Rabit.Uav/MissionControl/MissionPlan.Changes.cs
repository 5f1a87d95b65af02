using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

// What the operator can change in flight.
public sealed partial class MissionPlan
{
    /// <summary>Makes a mission whose values are set with it.</summary>
    public MissionPlan()
    {
    }

    private MissionPlan(MissionPlan other)
    {
        (Name, Area, KeepOuts) = (other.Name, other.Area, other.KeepOuts);
        (HeightMetres, _speed, LaneSpacingMetres) = (other.HeightMetres, other._speed, other.LaneSpacingMetres);
        (LaneHeading, Targets, Home) = (other.LaneHeading, other.Targets, other.Home);
        (TargetMotions, TargetClasses) = (other.TargetMotions, other.TargetClasses);
        (FenceMarginMetres, RequiredCoverage) = (other.FenceMarginMetres, other.RequiredCoverage);
        Revisit = other.Revisit;
        (CameraPitch, CameraYaw, HasGimbal) = (other.CameraPitch, other.CameraYaw, other.HasGimbal);
        MinBatteryFractionAtStart = other.MinBatteryFractionAtStart;
        EnergyReserveFraction = other.EnergyReserveFraction;
        (AllowsPartialSearch, AllowUnknownBattery) = (other.AllowsPartialSearch, other.AllowUnknownBattery);
        (MaxHeightMetres, MaxDistanceMetres) = (other.MaxHeightMetres, other.MaxDistanceMetres);
        (ObstacleHeightMetres, GroundStationLost) = (other.ObstacleHeightMetres, other.GroundStationLost);
    }

    /// <summary>
    /// The same that also searches for further classes of targets, which it declares; one that names no targets of
    /// interest goes on searching for all.
    /// </summary>
    /// <param name="classes">Those that it declares already, by their names, are searched for as it does.</param>
    public MissionPlan WithTargets(IEnumerable<TargetClass> classes)
    {
        if (classes is null)
            throw new ArgumentNullException(nameof(classes));
        TargetClass[] more = classes.GroupBy(c => c.Name).Select(c => c.First()).ToArray();
        ImmutableArray<TargetClass> own = TargetClasses.IsDefault ? [] : TargetClasses;
        return new(this)
        {
            TargetClasses = [.. own, .. more.Where(c => own.All(o => o.Name != c.Name))],
            Targets = Targets.IsDefaultOrEmpty
                ? []
                : [.. Targets, .. more.Select(c => c.Name).Where(n => !Targets.Contains(n))],
        };
    }

    /// <summary>The same whose camera is held by a gimbal that it points (<see cref="HasGimbal"/>).</summary>
    public MissionPlan WithGimbal() => new(this) { HasGimbal = true };

    /// <summary>The same, searched from another height.</summary>
    /// <param name="metres">As <see cref="HeightMetres"/>; it is checked with the plan.</param>
    public MissionPlan WithHeight(double metres) => new(this) { HeightMetres = metres };

    internal MissionPlan WithSpeed(double metresPerSecond)
        => new(this) { SpeedMetresPerSecond = metresPerSecond };

    /// <summary>The same with another area and other keep-outs.</summary>
    internal MissionPlan WithArea(
        ImmutableArray<GeodeticPosition> area, ImmutableArray<ImmutableArray<GeodeticPosition>> keepOuts)
        => new(this) { Area = area, KeepOuts = keepOuts.IsDefault ? [] : keepOuts };

    /// <summary>The same, flown higher, also where targets are revisited.</summary>
    internal MissionPlan HigherBy(double metres)
        => new(this) { HeightMetres = HeightMetres + metres, Revisit = new(Revisit) { HeightMetres = null } };

    /// <summary>One of its values, as a number; <see cref="With"/> sets it.</summary>
    internal double Get(MissionParameter parameter) => parameter switch
    {
        MissionParameter.Height => HeightMetres,
        MissionParameter.Speed => SpeedMetresPerSecond,
        MissionParameter.LaneSpacing => LaneSpacingMetres,
        MissionParameter.Revisits => Revisit.IsEnabled ? 1 : 0,
        MissionParameter.RevisitHeight => Revisit.HeightMetres ?? 0,
        MissionParameter.RevisitRadius => Revisit.RadiusMetres,
        MissionParameter.BatteryAtStart => MinBatteryFractionAtStart,
        MissionParameter.EnergyReserve => EnergyReserveFraction,
        MissionParameter.RequiredCoverage => RequiredCoverage,
        _ => throw new ArgumentOutOfRangeException(nameof(parameter), parameter, "It is none of the values."),
    };

    /// <summary>The same with another value, which is not checked.</summary>
    internal MissionPlan With(MissionParameter parameter, double value) => parameter switch
    {
        MissionParameter.Height => new(this) { HeightMetres = value },
        MissionParameter.Speed => WithSpeed(value),
        MissionParameter.LaneSpacing => new(this) { LaneSpacingMetres = value },
        MissionParameter.Revisits => new(this) { Revisit = new(Revisit) { IsEnabled = value > 0.5 } },
        MissionParameter.RevisitHeight => new(this)
        {
            Revisit = new(Revisit) { HeightMetres = value.Equals(0) ? null : value },
        },
        MissionParameter.RevisitRadius => new(this) { Revisit = new(Revisit) { RadiusMetres = value } },
        MissionParameter.BatteryAtStart => new(this) { MinBatteryFractionAtStart = value },
        MissionParameter.EnergyReserve => new(this) { EnergyReserveFraction = value },
        MissionParameter.RequiredCoverage => new(this) { RequiredCoverage = value },
        _ => throw new ArgumentOutOfRangeException(nameof(parameter), parameter, "It is none of the values."),
    };
}
