using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>
/// The height of the autopilot's return over the highest obstacle: RTL_ALT in centimetres, RTL_ALT_M in metres in newer
/// versions of ArduPilot, RTL_RETURN_ALT in metres in PX4.
/// </summary>
internal static class ReturnHeightRule
{
    public const string Name = "return-height";

    public static IReadOnlyList<(string Name, double Scale)> Ardupilot { get; } =
        [("RTL_ALT_M", 1), ("RTL_ALT", 0.01)];

    public static IReadOnlyList<(string Name, double Scale)> Px4 { get; } = [("RTL_RETURN_ALT", 1)];

    public static ParameterRule Create(IReadOnlyList<(string Name, double Scale)> names) => new()
    {
        Name = Name,
        Names = names,
        Test = ParameterTest.Custom(Judge, " m"),
        Pass = "obstacles, or the highest ground of a terrain grid, and the clearance (10 m) or more",
        Warn = "the mission names no obstacleHeightMetres",
        Fail = "below obstacles or terrain, and the clearance; 0 is the present height, which in a take-off is as low; "
            + "in a group, in the layer of another vehicle",
        Note = NoteOf,
        HowToSet = "set it above the obstacles that the mission file names by obstacleHeightMetres, and the terrain",
        Reason = "the return is a straight line at this height, or at the present one where that is higher",
    };

    /// <summary>The height of the return, metres above home; null where it was not read.</summary>
    public static double? HeightMetres(AutopilotParameters parameters)
    {
        foreach ((string name, double scale) in Ardupilot.Concat(Px4))
        {
            if (parameters.TryGet(name, out AutopilotParameter parameter))
                return parameter.Value * scale;
        }

        return null;
    }

    private static PreflightResult Judge(double metres, PreflightFacts facts)
    {
        double? obstacle = facts.Options.ObstacleHeightMetres;
        double? ground = MaxGroundMetres(facts);
        double clearance = facts.Options.MinObstacleClearanceMetres;
        if (metres < obstacle + clearance || metres < ground + clearance
            || metres > facts.Options.MaxReturnHeightMetres)
            return PreflightResult.Fail;

        // What stands on the ground, a grid of the ground does not say.
        return obstacle is null ? PreflightResult.Warn : PreflightResult.Pass;
    }

    private static string NoteOf(PreflightFacts facts)
    {
        string ground = MaxGroundMetres(facts) is { } metres
            ? string.Format(
                CultureInfo.InvariantCulture, ", terrain up to {0:0} m: {1:0} m or more", metres,
                metres + facts.Options.MinObstacleClearanceMetres)
            : string.Empty;
        return facts.Options.MaxReturnHeightMetres is { } limit
            ? ground + string.Format(CultureInfo.InvariantCulture, ", {0:0} m or less in the group", limit)
            : ground;
    }

    private static double? MaxGroundMetres(PreflightFacts facts)
        => facts.Vehicle.PositionTime is null
            ? null
            : facts.ReturnTerrain?.MaxAboveHomeMetres(facts.Vehicle.Position);
}
