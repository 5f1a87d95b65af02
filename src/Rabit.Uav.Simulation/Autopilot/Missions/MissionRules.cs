using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>What is taken for a mission, a fence and rally points: what is flown here, in global frames.</summary>
/// <param name="isFence">Whether items that are fine one by one are a fence.</param>
/// <param name="maxFenceItems">How many items a fence may have.</param>
/// <param name="maxRallyPoints">How many rally points there may be.</param>
internal sealed class MissionRules(Func<MissionItemInt[], bool> isFence, int maxFenceItems, int maxRallyPoints)
    : IMavlinkMissionRules
{
    private const int NorthPoleDegE7 = 900_000_000;
    private const int DateLineDegE7 = 1_800_000_000;
    private const int FirstDoCommand = 112;
    private const int LastDoCommand = 252;

    public MavMissionResult CheckTransfer(MavMissionType type, int count, MavlinkAddress source, bool isSigned)
        => type == MavMissionType.All ? MavMissionResult.Unsupported
            : type == MavMissionType.Fence && count > maxFenceItems ? MavMissionResult.NoSpace
            : type == MavMissionType.Rally && count > maxRallyPoints ? MavMissionResult.NoSpace
            : MavMissionResult.Accepted;

    public MavMissionResult CheckItem(in MissionItemInt item) => item.MissionType switch
    {
        MavMissionType.Fence => CheckFence(item),
        MavMissionType.Rally when item.Command != MavCmd.NavRallyPoint => MavMissionResult.Unsupported,
        MavMissionType.Mission when !IsKnown(item.Command) => MavMissionResult.Unsupported,
        MavMissionType.Mission when IsDo(item.Command) => MavMissionResult.Accepted,
        _ => CheckPlace(item),
    };

    public MavMissionResult CheckItems(MavMissionType type, ReadOnlySpan<MissionItemInt> items)
        => type != MavMissionType.Fence || isFence(items.ToArray())
            ? MavMissionResult.Accepted
            : MavMissionResult.Error;

    // A jump is not flown, and so not taken.
    private static bool IsKnown(MavCmd command) => IsDo(command)
        || command is MavCmd.NavWaypoint or MavCmd.NavTakeoff or MavCmd.NavLand or MavCmd.NavReturnToLaunch
            or MavCmd.NavLoiterUnlim or MavCmd.NavLoiterTime;

    private static bool IsDo(MavCmd command)
        => (int)command is >= FirstDoCommand and <= LastDoCommand && command != MavCmd.DoJump;

    private static MavMissionResult CheckFence(in MissionItemInt item)
    {
        bool isCircle = item.Command is MavCmd.NavFenceCircleInclusion or MavCmd.NavFenceCircleExclusion;
        bool isVertex =
            item.Command is MavCmd.NavFencePolygonVertexInclusion or MavCmd.NavFencePolygonVertexExclusion;
        if (!isCircle && !isVertex && item.Command != MavCmd.NavFenceReturnPoint)
            return MavMissionResult.Unsupported;
        if (!IsGlobal(item.Frame))
            return MavMissionResult.UnsupportedFrame;
        return (isCircle && !(item.Param1 > 0)) || (isVertex && !(item.Param1 >= 3))
            ? MavMissionResult.InvalidParam1
            : CheckPlace(item);
    }

    private static MavMissionResult CheckPlace(in MissionItemInt item)
        => !IsGlobal(item.Frame) && item.Command != MavCmd.NavReturnToLaunch ? MavMissionResult.UnsupportedFrame
            : item.X is < -NorthPoleDegE7 or > NorthPoleDegE7 ? MavMissionResult.InvalidParam5X
            : item.Y is < -DateLineDegE7 or > DateLineDegE7 ? MavMissionResult.InvalidParam6Y
            : MavMissionResult.Accepted;

    private static bool IsGlobal(MavFrame axes) => axes is MavFrame.Global or MavFrame.GlobalInt
        or MavFrame.GlobalRelativeAlt or MavFrame.GlobalRelativeAltInt;
}
