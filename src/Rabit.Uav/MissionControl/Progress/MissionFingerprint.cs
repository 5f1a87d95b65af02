using System;
using System.Globalization;
using System.Linq;
using System.Text;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Identifies what a mission flies: a hash over all values that decide where and how. Comments, the order of properties
/// and the name of the file do not matter.
/// </summary>
internal static class MissionFingerprint
{
    public static string Of(MissionPlan plan)
    {
        var text = new StringBuilder();
        text.Append(plan.Name).Append('\n');
        AddGround(text, plan);
        Add(
            text, plan.HeightMetres, plan.SpeedMetresPerSecond, plan.LaneSpacingMetres,
            plan.LaneHeading?.Radians ?? double.NaN, plan.FenceMarginMetres, plan.CameraPitch.Radians,
            plan.CameraYaw.Radians, plan.MaxHeightMetres ?? double.NaN, plan.MaxDistanceMetres ?? double.NaN,
            plan.Revisit.HeightMetres ?? double.NaN, plan.Revisit.RadiusMetres);
        text.Append(plan.HasGimbal).Append(plan.Revisit.IsEnabled).Append('\n');
        foreach (TargetClassName target in plan.Targets.IsDefault ? [] : plan.Targets)
            text.Append(target).Append('\n');
        return Sha256Hex.Of(text.ToString());
    }

    /// <summary>
    /// Identifies the lanes alone, for vehicles that share them: area, keep-outs, spacing and direction.
    /// </summary>
    public static uint OfLanes(MissionPlan plan)
    {
        var text = new StringBuilder();
        AddGround(text, plan);
        Add(text, plan.LaneSpacingMetres, plan.LaneHeading?.Radians ?? double.NaN);
        return Convert.ToUInt32(Sha256Hex.Of(text.ToString()).Remove(8), 16);
    }

    private static void AddGround(StringBuilder text, MissionPlan plan)
    {
        foreach (GeodeticPosition corner in plan.Area)
            Add(text, corner.Latitude.Radians, corner.Longitude.Radians);
        foreach (GeodeticPosition corner in plan.KeepOuts.IsDefault ? [] : plan.KeepOuts.SelectMany(k => k))
            Add(text, corner.Latitude.Radians, corner.Longitude.Radians, 1);
    }

    // As bits: runtimes print the same number differently.
    private static void Add(StringBuilder text, params double[] values)
    {
        foreach (double value in values)
        {
            text.Append(BitConverter.DoubleToInt64Bits(value).ToString("x16", CultureInfo.InvariantCulture))
                .Append('\n');
        }
    }
}
