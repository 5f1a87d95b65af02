using System;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Where a target is expected that goes round a curve.</summary>
public sealed class TargetTurnTests
{
    private const double Rate = 0.32;   // 8 m/s on 25 m

    [Fact]
    public void PlaceAt_TargetInACurve_IsOnTheCurve()
    {
        var turn = new TargetTurn();
        for (int i = 0; i < 40; i++)
            turn.Update(OnCircle(i * 0.5), OnCircle((i + 1) * 0.5));
        FollowMark last = OnCircle(20);

        Assert.Equal(Rate, turn.RadiansPerSecond, 1e-6);
        Assert.InRange(turn.PlaceAt(last, 2.5).DistanceTo(OnCircle(22.5).Place), 0, 1e-3);
    }

    [Fact]
    public void PlaceAt_TargetGoesStraight_IsAhead()
    {
        var turn = new TargetTurn();
        turn.Update(Straight(0), Straight(1));
        Assert.InRange(turn.PlaceAt(Straight(1), 3).DistanceTo(new PlanePoint(32, 0)), 0, 1e-9);
    }

    [Fact]
    public void Update_GapOrSlowTarget_ForgetsTheTurn()
    {
        var turn = new TargetTurn();
        turn.Update(OnCircle(0), OnCircle(1));
        Assert.True(turn.RadiansPerSecond > 0.1);
        turn.Update(OnCircle(1), OnCircle(4));
        Assert.Equal(0, turn.RadiansPerSecond);
        turn.Update(OnCircle(0), OnCircle(1));
        turn.Update(OnCircle(1), OnCircle(2) with { Velocity = new PlanePoint(1, 0) });
        Assert.Equal(0, turn.RadiansPerSecond);
    }

    [Fact]
    public void Update_JumpOfTheDirection_IsLimited()
    {
        var turn = new TargetTurn();
        turn.Update(Straight(0), Straight(1) with { Velocity = new PlanePoint(-8, 0.1) });
        Assert.Equal(0.4, turn.RadiansPerSecond, 9);
    }

    private static FollowMark OnCircle(double seconds) => new(
        new PlanePoint(25 * Math.Sin(Rate * seconds), 25 * (1 - Math.Cos(Rate * seconds))),
        8 * PlanePoint.Towards(Rate * seconds), TimeSpan.FromSeconds(seconds));

    private static FollowMark Straight(double seconds)
        => new(new PlanePoint(8 * seconds, 0), new PlanePoint(8, 0), TimeSpan.FromSeconds(seconds));
}
