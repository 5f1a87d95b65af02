using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Phases in which a test lets something happen.</summary>
public static class MissionPhases
{
    public static readonly TheoryData<MissionPhase> InTheAir
        = [MissionPhase.TakingOff, MissionPhase.InTransit, MissionPhase.Searching, MissionPhase.Revisiting];

    public static readonly TheoryData<MissionPhase> All
        = [MissionPhase.WaitingForVehicle, MissionPhase.Arming, MissionPhase.TakingOff, MissionPhase.InTransit,
            MissionPhase.Searching, MissionPhase.Revisiting, MissionPhase.Returning, MissionPhase.Landing];
}
