using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Validation of a mission: what it must be to be flown. Faults name the values as a mission file does.
/// </summary>
internal static class MissionPlanRules
{
    /// <summary>Maximum area of a search, square metres.</summary>
    public const double MaxAreaSquareMetres = 4e6;

    /// <summary>What drones may fly without a permission, in most countries.</summary>
    public const double MaxHeightMetres = 120;

    /// <summary>The least height of a mission, metres.</summary>
    public const double MinHeightMetres = 5;

    private const double MinAreaSquareMetres = 100;
    private const double MinKeepOutSquareMetres = 1;
    private const int MaxCorners = 50;
    private const double MinSpeed = 0.5;
    private const double MaxSpeed = 20;
    private const int MaxKeepOuts = 10;

    // With the corners of the fence they fit into the store of an autopilot.
    private const int MaxKeepOutCorners = 50;

    /// <summary>
    /// A lane ends up to half a spacing outside the area, and the vehicle overshoots and drifts.
    /// </summary>
    public const double FenceReserveMetres = 10;

    /// <summary>The height is held to a metre, and a barometer drifts by another.</summary>
    public const double HeightReserveMetres = 2;

    public static IEnumerable<string> FindFaults(MissionPlan plan)
        => PolygonFaults("area", plan.Area, MinAreaSquareMetres, plan.Area).Concat(KeepOutFaults(plan))
            .Concat(NumberFaults(plan)).Concat(FenceFaults(plan)).Concat(HomeFaults(plan)).Concat(LimitFaults(plan));

    /// <summary>Why a speed is none of a mission; null where it is.</summary>
    public static string? FindFaultOfSpeed(double metresPerSecond)
        => metresPerSecond >= MinSpeed && metresPerSecond <= MaxSpeed
            ? null
            : FormattableString.Invariant(
                $"speedMetresPerSecond is {metresPerSecond}; it must be {MinSpeed} to {MaxSpeed}");

    private static IEnumerable<string> NumberFaults(MissionPlan plan)
    {
        foreach ((string path, double value, double min, double max) in Ranges(plan))
        {
            if (!(value >= min && value <= max))
                yield return FormattableString.Invariant($"{path} is {value}; it must be {min} to {max}");
        }

        if (!plan.Targets.IsDefault && plan.Targets.Contains(TargetClassName.None))
            yield return "targets has an empty name";
        if (plan.TargetMotions is null || plan.TargetMotions.ContainsKey(TargetClassName.None))
            yield return "targetMotions is null or has an empty name";
        foreach (string fault in plan.TargetClasses.IsDefaultOrEmpty ? [] : TargetClass.FindFaults(plan.TargetClasses))
            yield return "targetClasses: " + fault;
        if (string.IsNullOrWhiteSpace(plan.Name) || plan.Name.Length > 80 || plan.Name.Any(char.IsControl))
            yield return "name must be a line of 1 to 80 characters";
    }

    private static IEnumerable<(string Path, double Value, double Min, double Max)> Ranges(MissionPlan plan)
    {
        yield return ("heightMetres", plan.HeightMetres, MinHeightMetres, MaxHeightMetres);
        yield return ("speedMetresPerSecond", plan.SpeedMetresPerSecond, MinSpeed, MaxSpeed);
        yield return ("laneSpacingMetres", plan.LaneSpacingMetres, 2, 200);
        yield return ("laneHeadingDegrees", ToDegrees(plan.LaneHeading ?? Angle.Zero), -360, 360);
        yield return ("fenceMarginMetres", plan.FenceMarginMetres, 0, 500);
        yield return ("requiredCoverage", plan.RequiredCoverage, 0, 1);
        yield return ("obstacleHeightMetres", plan.ObstacleHeightMetres ?? 0, 0, 500);
        yield return ("revisit.heightMetres", plan.Revisit.HeightMetres ?? MinHeightMetres, MinHeightMetres,
            MaxHeightMetres);
        yield return ("revisit.radiusMetres", plan.Revisit.RadiusMetres, 0, 100);
        yield return ("revisit.maxWayFraction", plan.Revisit.MaxWayFraction, 0, 10);
        yield return ("revisit.followSeconds", plan.Revisit.FollowTime.ExactSeconds, 0, 3600);
        yield return (
            "revisit.followSpeedMetresPerSecond", plan.Revisit.FollowSpeedMetresPerSecond ?? MinSpeed, MinSpeed,
            MaxSpeed);
        yield return ("camera.pitchDegrees", ToDegrees(plan.CameraPitch), -90, -20);
        yield return ("camera.yawDegrees", ToDegrees(plan.CameraYaw), -180, 180);
        yield return ("limits.minBatteryFractionAtStart", plan.MinBatteryFractionAtStart, 0, 1);
        yield return ("limits.energyReserveFraction", plan.EnergyReserveFraction, 0.05, 0.5);
        yield return (
            "limits.maxHeightMetres", plan.MaxHeightMetres ?? MaxHeightMetres, MinHeightMetres + HeightReserveMetres,
            MaxHeightMetres);
        yield return ("limits.maxDistanceMetres", plan.MaxDistanceMetres ?? 5000, 20, 5000);
        double hold = plan.GroundStationLost.HoldAfter?.ExactSeconds ?? 5;
        yield return ("groundStationLost.holdAfterSeconds", hold, 5, 600);
        yield return (
            "groundStationLost.returnAfterSeconds", plan.GroundStationLost.ReturnAfter?.ExactSeconds ?? 3600,
            Math.Max(5, Math.Min(hold, 600)), 3600);
    }

    private static IEnumerable<string> FenceFaults(MissionPlan plan)
    {
        double min = (plan.LaneSpacingMetres / 2) + FenceReserveMetres;
        if (plan.FenceMarginMetres < min)
        {
            yield return FormattableString.Invariant(
                $"fenceMarginMetres is {plan.FenceMarginMetres}; it must be at least {min}: lanes end up to half a spacing outside the area");
        }
    }

    // The distance of the lanes from home is checked when home is known.
    private static IEnumerable<string> LimitFaults(MissionPlan plan)
    {
        if (plan.MaxHeightMetres is not { } max)
            yield break;
        foreach ((string path, double? height) in new[]
        {
            ("heightMetres", plan.HeightMetres), ("revisit.heightMetres", plan.Revisit.HeightMetres),
        })
        {
            if (height > max - HeightReserveMetres)
            {
                yield return FormattableString.Invariant(
                    $"{path} is {height}; it must be {HeightReserveMetres} below limits.maxHeightMetres, {max}");
            }
        }
    }

    private static IEnumerable<string> HomeFaults(MissionPlan plan)
    {
        if (plan.Home is not { } home)
            yield break;
        if (!IsPosition(home.Latitude.Radians, home.Longitude.Radians))
            yield return "home is not a position: latitude must be -90 to 90, longitude -180 to 180 degrees";
        if (home.GroundAltitudeAmslMetres is { } altitude && !(altitude >= -500 && altitude <= 9000))
            yield return FormattableString.Invariant(
                $"home.groundAltitudeAmslMetres is {altitude}; it must be -500 to 9000");
    }

    private static IEnumerable<string> KeepOutFaults(MissionPlan plan)
    {
        if (plan.KeepOuts.IsDefaultOrEmpty || plan.Area.IsDefaultOrEmpty)
            yield break;
        int corners = plan.KeepOuts.Sum(k => k.IsDefault ? 0 : k.Length);
        if (plan.KeepOuts.Length > MaxKeepOuts || corners > MaxKeepOutCorners)
        {
            yield return FormattableString.Invariant(
                $"there are {plan.KeepOuts.Length} keepOuts with {corners} corners; the limits are {MaxKeepOuts} and {MaxKeepOutCorners}");
            yield break;
        }

        for (int i = 0; i < plan.KeepOuts.Length; i++)
        {
            string path = FormattableString.Invariant($"keepOuts[{i}]");
            foreach (string fault in PolygonFaults(path, plan.KeepOuts[i], MinKeepOutSquareMetres, plan.Area))
                yield return fault;
        }
    }

    private static IEnumerable<string> PolygonFaults(
        string path, ImmutableArray<GeodeticPosition> corners, double minArea, ImmutableArray<GeodeticPosition> area)
    {
        if (corners.IsDefault || corners.Length < 3 || corners.Length > MaxCorners)
        {
            int count = corners.IsDefault ? 0 : corners.Length;
            yield return FormattableString.Invariant($"{path} has {count} corners; it must have 3 to {MaxCorners}");
            yield break;
        }

        for (int i = 0; i < corners.Length; i++)
        {
            if (!IsPosition(corners[i].Latitude.Radians, corners[i].Longitude.Radians))
            {
                yield return FormattableString.Invariant(
                    $"{path}[{i}] is not a position: latitude must be -90 to 90, longitude -180 to 180 degrees");
                yield break;
            }
        }

        var frame = LocalNedFrame.IgnoringGeoid(area[0]);
        var polygon = new PlanePolygon(
            corners.Select(c => frame.ToNed(c)).Select(n => new PlanePoint(n.North, n.East)));
        foreach (string fault in ShapeFaults(path, polygon, minArea))
            yield return fault;
    }

    private static IEnumerable<string> ShapeFaults(string path, PlanePolygon polygon, double minArea)
    {
        // The local plane is an approximation: so far from its origin it lies a metre above the ellipsoid.
        const double MaxCornerDistance = 5000;
        for (int i = 0; i < polygon.Corners.Count; i++)
        {
            if (polygon.Corners[i].Length <= MaxCornerDistance)
                continue;
            yield return FormattableString.Invariant(
                $"{path}[{i}] is {polygon.Corners[i].Length:0} m from area[0]; corners must be within {MaxCornerDistance} m of it");
            yield break;
        }

        for (int i = 0; i < polygon.Corners.Count; i++)
        {
            if (polygon.Corners[i].DistanceTo(polygon.After(i)) >= 0.5)
                continue;
            yield return FormattableString.Invariant(
                $"{path}[{i}] and {path}[{(i + 1) % polygon.Corners.Count}] are the same position; the first corner is not repeated");
            yield break;
        }

        if (polygon.FindCrossing() is { } edges)
        {
            yield return FormattableString.Invariant(
                $"{path} crosses itself: the edges after {path}[{edges.First}] and {path}[{edges.Second}] intersect");
        }
        else if (!(polygon.Area >= minArea && polygon.Area <= MaxAreaSquareMetres))
        {
            yield return FormattableString.Invariant(
                $"{path} has {polygon.Area:0} m2; it must have {minArea} to {MaxAreaSquareMetres}");
        }
    }

    private static bool IsPosition(double latitude, double longitude)
        => Math.Abs(latitude) <= Math.PI / 2 && Math.Abs(longitude) <= Math.PI;

    // Degrees of a file are reported as they were given, and not a rounding above their limit.
    private static double ToDegrees(Angle angle) => Math.Round(angle.Degrees, 9);
}
