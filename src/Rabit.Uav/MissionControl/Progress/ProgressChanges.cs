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
/// What the operator had changed of the mission when its progress was written: the mission file does not say it.
/// Immutable.
/// </summary>
internal sealed class ProgressChanges(
    ImmutableArray<ImmutableArray<GeodeticPosition>> polygons,
    ImmutableArray<(MissionParameter Parameter, double Value)> values)
{
    private const int MaxPolygons = 50;
    private const int MaxNumbers = 1000;

    public static readonly ProgressChanges None = new([], []);

    /// <summary>The changes that make one mission of another.</summary>
    public static ProgressChanges Of(MissionPlan filed, MissionPlan now)
    {
        if (ReferenceEquals(filed, now))
            return None;
        bool isSameArea = filed.Area.Equals(now.Area) && filed.KeepOuts.Equals(now.KeepOuts);
        return new ProgressChanges(
            isSameArea ? [] : now.KeepOuts.Insert(0, now.Area),
            MissionParameterList.All.Where(p => !filed.Get(p).Equals(now.Get(p))).Select(p => (p, now.Get(p)))
                .ToImmutableArray());
    }

    /// <summary>The mission with them; it is not checked.</summary>
    public MissionPlan ApplyTo(MissionPlan filed)
    {
        MissionPlan changed = polygons.IsEmpty ? filed : filed.WithArea(polygons[0], polygons.RemoveAt(0));
        return values.Aggregate(changed, (plan, v) => plan.With(v.Parameter, v.Value));
    }

    /// <summary>Writes them as a property, where there are any.</summary>
    public void Write(Utf8JsonWriter json)
    {
        if (polygons.IsEmpty && values.IsEmpty)
            return;
        json.WriteStartObject("changed");
        json.WriteStartArray("areaAndKeepOuts");
        foreach (ImmutableArray<GeodeticPosition> polygon in polygons)
        {
            json.WriteStartArray();
            foreach (GeodeticPosition corner in polygon)
            {
                json.WriteNumberValue(corner.Latitude.Degrees);
                json.WriteNumberValue(corner.Longitude.Degrees);
            }

            json.WriteEndArray();
        }

        json.WriteEndArray();
        foreach ((MissionParameter parameter, double value) in values)
            json.WriteNumber(parameter.ToString(), value);
        json.WriteEndObject();
    }

    /// <summary>Reads them from the fields of a progress file; none where it has none.</summary>
    public static ProgressChanges Read(JsonFields root, List<string> faults)
    {
        if (!root.Has("changed"))
            return None;
        JsonFields fields = root.Object("changed");
        var polygons = ImmutableArray.CreateBuilder<ImmutableArray<GeodeticPosition>>();
        foreach (JsonElement polygon in fields.Array("areaAndKeepOuts")?.EnumerateArray().Take(MaxPolygons) ?? [])
            polygons.Add(ReadPolygon(polygon, faults));
        var values = ImmutableArray.CreateBuilder<(MissionParameter, double)>();
        foreach (MissionParameter parameter in MissionParameterList.All)
        {
            if (fields.Number(parameter.ToString()) is { } value)
                values.Add((parameter, value));
        }

        return new ProgressChanges(polygons.ToImmutable(), values.ToImmutable());
    }

    private static ImmutableArray<GeodeticPosition> ReadPolygon(JsonElement polygon, List<string> faults)
    {
        bool isList = polygon.ValueKind == JsonValueKind.Array;
        double[] numbers = isList
            ? polygon.EnumerateArray().Take(MaxNumbers)
                .Select(e => e.ValueKind == JsonValueKind.Number && e.TryGetDouble(out double n) ? n : double.NaN)
                .ToArray()
            : [];
        var corners = ImmutableArray.CreateBuilder<GeodeticPosition>();
        for (int i = 0; i + 1 < numbers.Length; i += 2)
        {
            if (Math.Abs(numbers[i]) <= 90 && Math.Abs(numbers[i + 1]) <= 180)
                corners.Add(GeodeticPosition.FromDegrees(numbers[i], numbers[i + 1], 0));
        }

        if (corners.Count * 2 != numbers.Length || corners.Count == 0)
            faults.Add("changed.areaAndKeepOuts has a polygon that is none");
        return corners.ToImmutable();
    }
}
