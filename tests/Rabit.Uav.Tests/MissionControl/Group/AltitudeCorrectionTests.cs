using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>How much higher a vehicle is by its satellite receiver than by its autopilot.</summary>
public sealed class AltitudeCorrectionTests
{
    private readonly AltitudeCorrection _correction = new();
    private double _seconds;

    [Fact]
    public void Metres_NothingReported_IsNotKnown() => Assert.Null(_correction.Metres);

    [Fact]
    public void Metres_FewReports_IsNotKnown()
    {
        for (int i = 0; i < 18; i++)
            Take(2);
        Assert.Null(_correction.Metres);
        for (int i = 0; i < 3; i++)
            Take(2);
        Assert.Equal(2, _correction.Metres!.Value, 1e-9);
    }

    [Fact]
    public void Update_NoisyReceiver_IsTheMean()
    {
        for (int i = 0; i < 60; i++)
            Take(3 + (i % 2 == 0 ? 1 : -1));
        Assert.Equal(3, _correction.Metres!.Value, 0.2);
    }

    [Fact]
    public void Update_BarometerDrifts_FollowsWithinAMinute()
    {
        for (int i = 0; i < 200; i++)
            Take(0);
        for (int i = 0; i < 120; i++)
            Take(4);
        Assert.InRange(_correction.Metres!.Value, 3.3, 4);
    }

    [Theory]
    [InlineData("climbs")]
    [InlineData("far off")]
    [InlineData("uncertain")]
    [InlineData("no fix")]
    [InlineData("old position")]
    [InlineData("not a number")]
    public void Update_CannotBeUsed_ChangesNothing(string what)
    {
        for (int i = 0; i < 60; i++)
            Take(2);
        VehicleState state = State(what is "far off" ? 60 : 10);
        if (what is "climbs")
            state.VelocityNed = new NedVector(0, 0, -2);
        else if (what is "uncertain")
            state.GnssAltitudeSigmaMetres = 6;
        else if (what is "no fix")
            state.GnssAltitudeAmslMetres = null;
        else if (what is "old position")
            state.PositionTime = TimeSpan.Zero;
        else if (what is "not a number")
            state.GnssAltitudeAmslMetres = double.NaN;
        for (int i = 0; i < 60; i++)
        {
            _seconds += 0.5;
            state.GpsTime = TimeSpan.FromSeconds(_seconds);
            if (what is not "old position")
                state.PositionTime = state.GpsTime;
            _correction.Update(state, TimeSpan.FromSeconds(_seconds));
        }

        Assert.Equal(2, _correction.Metres!.Value, 1e-9);
    }

    // A climb, or a time without a fix.
    [Fact]
    public void Update_FirstReportAfterAGap_CountsAsOne()
    {
        for (int i = 0; i < 60; i++)
            Take(2);
        _seconds += 40;
        Take(5);
        Assert.InRange(_correction.Metres!.Value, 2.1, 2.21);
    }

    [Fact]
    public void Update_TimeGoesBack_ChangesNothing()
    {
        for (int i = 0; i < 60; i++)
            Take(2);
        _seconds -= 20;
        Take(5);
        Assert.Equal(2, _correction.Metres!.Value, 1e-9);
    }

    [Fact]
    public void Update_SameReportAgain_CountsOnce()
    {
        for (int i = 0; i < 30; i++)
            Take(i % 2 == 0 ? 0 : 2);
        double? after = _correction.Metres;
        VehicleState state = State(2);
        state.GpsTime = TimeSpan.FromSeconds(_seconds);
        for (int i = 0; i < 10; i++)
            _correction.Update(state, TimeSpan.FromSeconds(_seconds + 0.1));
        Assert.NotNull(after);
        Assert.Equal(after, _correction.Metres);
    }

    private void Take(double above)
    {
        _seconds += 0.5;
        _correction.Update(State(above), TimeSpan.FromSeconds(_seconds));
    }

    private VehicleState State(double above) => new()
    {
        Position = GeodeticPosition.FromDegrees(47.4, 8.5, 530),
        PositionTime = TimeSpan.FromSeconds(_seconds),
        GpsTime = TimeSpan.FromSeconds(_seconds),
        GnssAltitudeAmslMetres = 530 + above,
        GnssAltitudeSigmaMetres = 1.5,
    };
}
