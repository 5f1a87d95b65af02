using System;
using System.Collections.Immutable;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>What a mission file says: which area to search, how, for what. Immutable. The form of the file is in docs/mission-file.md.</summary>
public sealed class MissionPlan
{
    /// <summary>Name of the mission.</summary>
    public string Name { get; init; } = "search";

    /// <summary>Corners of the area to search, in order, the first not repeated; altitudes are not used.</summary>
    public ImmutableArray<GeodeticPosition> Area { get; init; } = [];

    /// <summary>Height of the search above home, metres.</summary>
    public double HeightMetres { get; init; }

    /// <summary>Ground speed on all ways, metres per second.</summary>
    public double SpeedMetresPerSecond { get; init; }

    /// <summary>From lane to lane at most, metres.</summary>
    public double LaneSpacingMetres { get; init; }

    /// <summary>Direction of the lanes, radians clockwise from true north; null for the one that needs the fewest lanes.</summary>
    public double? LaneHeadingRadians { get; init; }

    /// <summary>The colours of the targets of interest.</summary>
    public TargetColours Targets { get; init; } = TargetColours.All;

    /// <summary>Where the vehicle is expected to stand; null where that does not matter.</summary>
    public MissionHome? Home { get; init; }

    /// <summary>How far the vehicle may leave the smallest convex shape around area and home, metres.</summary>
    public double FenceMarginMetres { get; init; } = 40;

    /// <summary>How each new target is looked at again.</summary>
    public RevisitPlan Revisit { get; init; } = new();

    /// <summary>Camera pitch against the body, radians, up positive; -pi/2 looks straight down.</summary>
    public double CameraPitchRadians { get; init; } = -Math.PI / 2;

    /// <summary>Camera yaw against the body, radians, right positive.</summary>
    public double CameraYawRadians { get; init; }

    /// <summary>Whether the camera hangs in a gimbal that is to be turned there; otherwise it is mounted so.</summary>
    public bool HasGimbal { get; init; }

    /// <summary>What must remain in the battery at the start, 0 to 1.</summary>
    public double MinBatteryToStart { get; init; } = 0.5;

    /// <summary>Reads a mission file and checks it.</summary>
    /// <param name="json">The text of the file.</param>
    /// <param name="name">What to call it in errors and where it has no name: the name of the file.</param>
    /// <exception cref="MissionPlanException">It is no mission, or not one that can be flown; the text names all that is wrong with it.</exception>
    public static MissionPlan Parse(string json, string name)
    {
        if (json is null)
            throw new ArgumentNullException(nameof(json));
        if (string.IsNullOrWhiteSpace(name))
            throw new ArgumentException("A mission needs a name that errors can call it by.", nameof(name));
        return MissionPlanReader.Read(json, name);
    }
}
