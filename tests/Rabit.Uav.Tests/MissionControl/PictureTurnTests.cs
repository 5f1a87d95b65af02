using System;
using Rabit.Geodesy;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>How a vehicle turns its picture to the way of the target that it follows.</summary>
public sealed class PictureTurnTests
{
    private const double Degree = Angle.RadiansPerDegree;
    private static readonly Angle Across = Angle.FromDegrees(90);

    [Theory]
    [InlineData(0, 90, 0)]          // to the east: the columns lie along its way already
    [InlineData(10, 0, 90)]
    [InlineData(0, 80, -10)]
    [InlineData(170, 0, 90)]        // either end of the side may be ahead: the nearer turn
    [InlineData(-170, 0, -90)]
    [InlineData(170, -75, -165)]
    public void Update_FastTarget_TurnsTheLongerSideToItsWay(double heading, double course, double expected)
    {
        var turn = new PictureTurn(heading * Degree, Across);
        turn.Update(Mark(8, course));
        Assert.Equal(0, Math.IEEERemainder(turn.HeadingRadians - (expected * Degree), 2 * Math.PI), 1e-9);
        Assert.InRange(Math.Abs(turn.HeadingRadians), 0, Math.PI);
    }

    [Fact]
    public void Update_SlowTargetOrPictureWithoutALongerSide_KeepsTheHeading()
    {
        var slow = new PictureTurn(0.5, Across);
        slow.Update(Mark(1.5, 0));
        Assert.Equal(0.5, slow.HeadingRadians);
        var square = new PictureTurn(0.5, longerSide: null);
        square.Update(Mark(8, 0));
        Assert.Equal(0.5, square.HeadingRadians);
    }

    private static FollowMark Mark(double speed, double courseDegrees)
        => new(default, speed * PlanePoint.Towards(courseDegrees * Degree), TimeSpan.Zero);
}
