using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>The table of the operator's commands.</summary>
public class OperatorRulesTests
{
    // y: not refused by the table. In the order of the commands: hold, return, continue, land, skip lane, revisit,
    // revisit place, confirm, reject, change speed, change parameter, offer area.
    [Theory]
    [InlineData(MissionPhase.NoMission, "............")]
    [InlineData(MissionPhase.WaitingForVehicle, "yy.y...yyyyy")]
    [InlineData(MissionPhase.Arming, "yy.y...yyyyy")]
    [InlineData(MissionPhase.TakingOff, "yy.yy..yyyyy")]
    [InlineData(MissionPhase.InTransit, "yy.yyyyyyyyy")]
    [InlineData(MissionPhase.Searching, "yy.yyyyyyyyy")]
    [InlineData(MissionPhase.Revisiting, "yy.yy..yyyyy")]
    [InlineData(MissionPhase.Holding, "yyyyyyyyyyyy")]
    [InlineData(MissionPhase.Returning, "y..y...yy.yy")]
    [InlineData(MissionPhase.Landing, "y......yy.yy")]
    [InlineData(MissionPhase.HandedOver, "yyy....yy.yy")]
    [InlineData(MissionPhase.Done, ".......yy...")]
    [InlineData(MissionPhase.Failed, ".......yy...")]
    public void Table_EachPhaseAndCommand_IsAsDocumented(MissionPhase phase, string expected)
        => Assert.Equal(
            expected,
            string.Concat(EnumValues.Of<OperatorCommand>()
                .Select(c => OperatorRules.FindRefusal(phase, c) is null ? 'y' : '.')));

    // What is not refused and changes the phase has a way in the table of the transitions, or gives up on the ground.
    [Fact]
    public void Table_CommandsThatChangeThePhase_AreTransitions()
    {
        foreach (MissionPhase phase in EnumValues.Of<MissionPhase>())
        {
            foreach (OperatorCommand command in EnumValues.Of<OperatorCommand>())
            {
                if (OperatorRules.FindRefusal(phase, command) is not null
                    || !OperatorRules.ChangesPhase(phase, command)
                    || phase is MissionPhase.WaitingForVehicle or MissionPhase.Arming)
                    continue;
                MissionEvent what = OperatorRules.ToStep(new OperatorRequest(command, "test", "test")).What;
                bool beginsAgain = (phase, command) is (MissionPhase.Holding, OperatorCommand.Hold)
                    or (MissionPhase.InTransit, OperatorCommand.SkipLane);
                Assert.Equal(beginsAgain, MissionTransitions.After(phase, what) == phase);
            }
        }
    }
}
