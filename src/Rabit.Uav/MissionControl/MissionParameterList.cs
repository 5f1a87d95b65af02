using System.Collections.Immutable;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>The values of a mission that the operator can change.</summary>
internal static class MissionParameterList
{
    public static readonly ImmutableArray<MissionParameter> All =
    [
        MissionParameter.Height, MissionParameter.Speed, MissionParameter.LaneSpacing, MissionParameter.Revisits,
        MissionParameter.RevisitHeight, MissionParameter.RevisitRadius, MissionParameter.BatteryAtStart,
        MissionParameter.EnergyReserve, MissionParameter.RequiredCoverage,
    ];
}
