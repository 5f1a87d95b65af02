using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Globalization;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Web.State;

/// <summary>
/// Area, fence, keep-outs, lanes and home, in groups of points that fit a message; written again when the plan is
/// another one.
/// </summary>
internal sealed class PlanItems(string prefix)
{
    private const int PointsInGroup = 80;

    // 16 000 points: more is no plan that a person looks at.
    private const int MaxGroups = 200;

    private readonly List<string> _keys = [];
    private SearchPlan? _plan;

    public void Write(ItemWriter writer, PageState state, SearchPlan? plan)
    {
        if (ReferenceEquals(plan, _plan))
            return;
        _plan = plan;
        List<string> before = [.. _keys];
        _keys.Clear();
        if (plan is not null)
        {
            WriteSummary(writer, plan);
            WritePoints(writer, "area", plan.Area);
            WritePoints(writer, "fence", plan.Fence);
            for (int i = 0; i < plan.KeepOuts.Length; i++)
                WritePoints(writer, string.Create(CultureInfo.InvariantCulture, $"keepout{i}"), plan.KeepOuts[i]);
            WritePoints(writer, "lanes", plan.Lanes);
        }

        foreach (string key in before)
        {
            if (!_keys.Contains(key))
                state.Remove(key);
        }
    }

    private void WriteSummary(ItemWriter writer, SearchPlan plan)
    {
        string key = prefix + "/plan";
        _keys.Add(key);
        writer.Object(key).Text("name", plan.Name, 80).Number("lat", plan.Home.Latitude.Degrees, 7)
            .Number("lon", plan.Home.Longitude.Degrees, 7).Number("height", plan.HeightAboveHomeMetres, 1)
            .Number("speed", plan.SpeedMetresPerSecond, 1).End();
    }

    // A group is a list of [latitude, longitude]; a figure is all its groups, in order.
    private void WritePoints(ItemWriter writer, string figure, ImmutableArray<GeodeticPosition> points)
    {
        for (int first = 0; first < points.Length && _keys.Count < MaxGroups; first += PointsInGroup)
        {
            string key = string.Create(CultureInfo.InvariantCulture, $"{prefix}/plan/{figure}/{first / PointsInGroup}");
            _keys.Add(key);
            writer.Array(key);
            for (int i = first; i < Math.Min(points.Length, first + PointsInGroup); i++)
                writer.Inner().Number(points[i].Latitude.Degrees, 6).Number(points[i].Longitude.Degrees, 6).EndInner();
            writer.End();
        }
    }
}
