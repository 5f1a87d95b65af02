using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

public class MissionTransitionsTests
{
    private static readonly MissionPhase[] Ends =
        [MissionPhase.NoMission, MissionPhase.Done, MissionPhase.Failed];

    private static readonly MissionEvent[] Operators =
        [.. EnumValues.Of<MissionEvent>().Where(OperatorRules.IsCommand)];

    private static readonly MissionPhase[] All = EnumValues.Of<MissionPhase>();

    private static readonly MissionEvent[] Events = EnumValues.Of<MissionEvent>();

    [Fact]
    public void Table_Ends_AreNeverLeft()
        => Assert.All(Ends, end => Assert.All(Events, what => Assert.Equal(end, MissionTransitions.After(end, what))));

    [Fact]
    public void Table_OtherPhases_CanAlwaysBeHandedOverAndFail()
        => Assert.All(All.Except(Ends).Except([MissionPhase.HandedOver]), phase =>
        {
            Assert.Equal(MissionPhase.HandedOver, MissionTransitions.After(phase, MissionEvent.TakenOver));
            Assert.Equal(MissionPhase.Failed, MissionTransitions.After(phase, MissionEvent.Impossible));
            Assert.Equal(phase, MissionTransitions.After(phase, MissionEvent.None));
        });

    [Fact]
    public void Table_HandedOver_IsLeftAtTheOperatorsCommandOnly()
        => Assert.All(Events.Except(Operators), what
            => Assert.Equal(MissionPhase.HandedOver, MissionTransitions.After(MissionPhase.HandedOver, what)));

    [Fact]
    public void Table_Return_GoesBackToTheSearchAtTheOperatorsCommandOnly()
    {
        var reached = new HashSet<MissionPhase> { MissionPhase.Returning };
        for (int before = 0; before != reached.Count;)
        {
            before = reached.Count;
            foreach (MissionPhase phase in reached.ToList())
                reached.UnionWith(Events.Except(Operators).Select(e => MissionTransitions.After(phase, e)));
        }

        Assert.Equal(
            [MissionPhase.Returning, MissionPhase.Landing, MissionPhase.Done, MissionPhase.HandedOver,
                MissionPhase.Failed],
            reached.OrderBy(p => p));
    }
}
