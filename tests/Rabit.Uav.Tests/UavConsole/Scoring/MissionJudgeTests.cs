using System;
using Rabit.Uav.Messages;
using UavConsole;
using Xunit;

namespace Rabit.Uav.Tests.UavConsole;

/// <summary>What a mission is failed by beside its targets.</summary>
public sealed class MissionJudgeTests
{
    [Fact]
    public void Judge_GivenUpAndTruthNotKnown_HasFailed()
        => Assert.Equal("the search was given up before its end: no pictures", Assert.Single(MissionJudge.Judge(Flown("no pictures", isArmed: false), null, null).Failures));

    [Fact]
    public void Judge_FlownToItsEndAndTruthNotKnown_HasPassed()
        => Assert.True(MissionJudge.Judge(Flown(null, isArmed: false), null, null).HasPassed);

    [Fact]
    public void Judge_StillInTheAir_SaysWhereAndThatWeCommandItNoMore()
        => Assert.Equal(
            "it has not landed: it is armed, 29.8 m high, in mode GUIDED; we command it no more",
            Assert.Single(MissionJudge.Judge(Flown(null, isArmed: true), null, null).Failures));

    private static FlightRecord Flown(string? aborted, bool isArmed) => new()
    {
        Mission = new MissionStatus { Plan = MadeUpFlight.Plan, Phase = MissionPhase.Done, Aborted = aborted },
        Vehicle = new VehicleState
        {
            IsArmed = isArmed,
            Mode = "GUIDED",
            HeightAboveHomeMetres = 29.8,
            PositionTime = TimeSpan.FromSeconds(90),
            Position = MadeUpFlight.Home,
        },
        GreatestHeightMetres = 30,
    };
}
