using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.Json;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Reads a mission file field by field, so that all faults are reported together, each with its path and value.
/// </summary>
internal static class MissionPlanReader
{
    private const int MaxTextLength = 1_000_000;

    private static readonly JsonDocumentOptions Form = new()
    {
        AllowTrailingCommas = true,
        CommentHandling = JsonCommentHandling.Skip,
        MaxDepth = 16,
    };

    /// <exception cref="MissionPlanException">The text is not a mission, or not one that can be flown.</exception>
    public static MissionPlan Read(string json, string name, string folder)
    {
        if (json.Length > MaxTextLength)
        {
            throw new MissionPlanException(
                name, [FormattableString.Invariant($"it has {json.Length} characters; the limit is {MaxTextLength}")]);
        }

        try
        {
            using JsonDocument document = JsonDocument.Parse(json, Form);
            JsonTexts.Demand(document.RootElement);
            return Read(document.RootElement, name, folder);
        }
        catch (JsonException e)
        {
            if (e.LineNumber is not { } line)
                throw new MissionPlanException(name, ["it is not JSON: " + e.Message]);
            string reason = e.Message.Split('.')[0];
            string place = FormattableString.Invariant($"line {line + 1}, byte {e.BytePositionInLine + 1}");
            throw new MissionPlanException(name, [$"it is not JSON: {place}: {reason}"]);
        }
    }

    private static MissionPlan Read(JsonElement root, string name, string folder)
    {
        var faults = new List<string>();
        if (root.ValueKind != JsonValueKind.Object)
            throw new MissionPlanException(name, ["it must be an object, { ... }"]);
        var fields = new JsonFields(root, string.Empty, faults);
        MissionPlan plan = ReadPlan(fields, name, folder);
        fields.RefuseOthers();

        // A value that could not be read would be reported twice.
        if (faults.Count == 0)
            faults.AddRange(MissionPlanRules.FindFaults(plan));
        return faults.Count > 0 ? throw new MissionPlanException(name, faults) : plan;
    }

    private static MissionPlan ReadPlan(JsonFields fields, string name, string folder)
    {
        JsonFields camera = fields.Object("camera");
        JsonFields limits = fields.Object("limits");
        JsonFields revisit = fields.Object("revisit");
        fields.Renamed(("secondLook", "revisit"));
        limits.Renamed(("minBatteryToStart", "minBatteryFractionAtStart"));
        string title = fields.Text("name") ?? name;
        ImmutableArray<ImmutableArray<GeodeticPosition>> area = ReadArea(fields);
        var plan = new MissionPlan
        {
            Name = title,
            Area = area.IsEmpty ? [] : area[0],
            HeightMetres = fields.Number("heightMetres") ?? fields.Missing("heightMetres"),
            SpeedMetresPerSecond = fields.Number("speedMetresPerSecond") ?? fields.Missing("speedMetresPerSecond"),
            LaneSpacingMetres = fields.Number("laneSpacingMetres") ?? fields.Missing("laneSpacingMetres"),
            LaneHeading = ToAngle(fields.Number("laneHeadingDegrees")),
            Targets = ReadTargets(fields),
            TargetMotions = ReadTargetMotions(fields),
            TargetClasses = MissionTargetClassReader.Read(fields, folder),
            Home = ReadHome(fields),
            FenceMarginMetres = fields.Number("fenceMarginMetres") ?? 40,
            Revisit = new RevisitPlan
            {
                IsEnabled = revisit.Flag("enabled") ?? true,
                HeightMetres = revisit.Number("heightMetres"),
                RadiusMetres = revisit.Number("radiusMetres") ?? 10,
                MaxWayFraction = revisit.Number("maxWayFraction") ?? 1.0 / 3,
                FollowTime = ToTime(revisit.Number("followSeconds") ?? 20),
                FollowSpeedMetresPerSecond = revisit.Number("followSpeedMetresPerSecond"),
            },
            CameraPitch = Angle.FromDegrees(camera.Number("pitchDegrees") ?? -90),
            CameraYaw = Angle.FromDegrees(camera.Number("yawDegrees") ?? 0),
            HasGimbal = camera.Flag("gimbal") ?? false,
            RequiredCoverage = fields.Number("requiredCoverage") ?? MissionPlan.DefaultRequiredCoverage,
            ObstacleHeightMetres = fields.Number("obstacleHeightMetres"),
            MinBatteryFractionAtStart = limits.Number("minBatteryFractionAtStart") ?? 0.5,
            EnergyReserveFraction = limits.Number("energyReserveFraction") ?? 0.1,
            AllowsPartialSearch = fields.Flag("allowPartialSearch") ?? false,
            AllowUnknownBattery = limits.Flag("allowUnknownBattery") ?? false,
            MaxHeightMetres = limits.Number("maxHeightMetres"),
            MaxDistanceMetres = limits.Number("maxDistanceMetres"),
            GroundStationLost = ReadGroundStationLost(fields),
            KeepOuts = ReadKeepOuts(fields, area.Skip(1)),
        };
        camera.RefuseOthers();
        limits.RefuseOthers();
        revisit.RefuseOthers();
        return plan;
    }

    private static GroundStationLoss ReadGroundStationLost(JsonFields fields)
    {
        JsonFields loss = fields.Object("groundStationLost");
        string action = loss.Choice("action", "return", "hold", "continue") ?? "return";
        TimeSpan hold = ToTime(loss.Number("holdAfterSeconds") ?? 10);
        TimeSpan back = ToTime(loss.Number("returnAfterSeconds") ?? 30);
        loss.RefuseOthers();
        return new GroundStationLoss
        {
            HoldAfter = action == "continue" ? null : hold,
            ReturnAfter = action == "return" ? back : null,
        };
    }

    private static ImmutableArray<ImmutableArray<GeodeticPosition>> ReadArea(JsonFields fields)
    {
        if (fields.Any("area") is { } area)
            return MissionPolygonReader.Read(fields, "area", area);
        fields.Missing("area");
        return [];
    }

    // The holes of the area are keep-outs like the others.
    private static ImmutableArray<ImmutableArray<GeodeticPosition>> ReadKeepOuts(
        JsonFields fields, IEnumerable<ImmutableArray<GeodeticPosition>> holes)
    {
        var keepOuts = new List<ImmutableArray<GeodeticPosition>>();
        if (fields.Array("keepOuts") is { } polygons)
        {
            int index = 0;
            foreach (JsonElement polygon in polygons.EnumerateArray())
            {
                string path = MissionPolygonReader.Item("keepOuts", index++);
                ImmutableArray<ImmutableArray<GeodeticPosition>> rings = MissionPolygonReader.Read(
                    fields, path, polygon);
                if (rings.Length > 1)
                    fields.Blame(path, polygon, "must have no holes");
                keepOuts.AddRange(rings.Take(1));
            }
        }

        return keepOuts.Concat(holes).ToImmutableArray();
    }

    private static ImmutableArray<TargetClassName> ReadTargets(JsonFields fields)
    {
        if (fields.Array("targets") is not { } names)
            return [];
        var targets = ImmutableArray.CreateBuilder<TargetClassName>();
        int index = 0;
        foreach (JsonElement name in names.EnumerateArray())
        {
            if (name.ValueKind != JsonValueKind.String
                || !TargetClassName.TryParse(name.GetString(), out TargetClassName target))
                fields.Blame(
                    MissionPolygonReader.Item("targets", index), name,
                    "must be the name of a target class: " + TargetClassName.Rule);
            else if (!targets.Contains(target))
                targets.Add(target);
            index++;
        }

        if (index == 0)
            fields.Blame("targets", names, "must name at least one target class");
        return targets.ToImmutable();
    }

    private static ImmutableDictionary<TargetClassName, TargetMotion> ReadTargetMotions(JsonFields fields)
    {
        var motions = ImmutableDictionary.CreateBuilder<TargetClassName, TargetMotion>();
        JsonFields given = fields.Object("targetMotions");
        foreach (string name in given.Names)
        {
            string? motion = given.Choice(name, "standing", "walking", "vehicle");
            if (!TargetClassName.TryParse(name, out TargetClassName target))
                given.Blame(
                    name, given.Any(name)!.Value, "must be by the name of a target class: " + TargetClassName.Rule);
            else if (motion is not null)
                motions[target] = motion switch
                {
                    "walking" => TargetMotion.Walking,
                    "vehicle" => TargetMotion.Vehicle,
                    _ => TargetMotion.Standing,
                };
        }

        return motions.ToImmutable();
    }

    private static MissionHome? ReadHome(JsonFields fields)
    {
        if (!fields.Has("home"))
            return null;
        JsonFields home = fields.Object("home");
        home.Renamed(("lat", "latitudeDegrees"), ("lon", "longitudeDegrees"));
        var read = new MissionHome
        {
            Latitude = Angle.FromDegrees(home.Number("latitudeDegrees") ?? home.Missing("latitudeDegrees")),
            Longitude = Angle.FromDegrees(home.Number("longitudeDegrees") ?? home.Missing("longitudeDegrees")),
            GroundAltitudeAmslMetres = home.Number("groundAltitudeAmslMetres"),
        };
        home.RefuseOthers();
        return read;
    }

    // What is no number, or far out of its range, is a fault elsewhere.
    private static TimeSpan ToTime(double seconds)
        => TimeSpan.OfSeconds(double.IsNaN(seconds) ? 0 : Math.Max(-1e6, Math.Min(1e6, seconds)));

    private static Angle? ToAngle(double? degrees) => degrees is { } number ? Angle.FromDegrees(number) : null;
}
