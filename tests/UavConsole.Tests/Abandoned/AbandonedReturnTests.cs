using System;
using System.IO;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.Communications;
using Xunit;

namespace UavConsole.Tests.Abandoned;

/// <summary>When a vehicle that a failed flight left behind is asked to return, and when it is left alone.</summary>
public sealed class AbandonedReturnTests : IDisposable
{
    private readonly TestLog _folder = new();

    private string StateFile => Path.Combine(_folder.Folder, "progress.json");

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData(MavLandedState.InAir, 0)]
    [InlineData(MavLandedState.Takeoff, 0)]
    [InlineData(MavLandedState.Undefined, 30)]
    public void FindReasonToStay_HoversInGuided_IsNone(MavLandedState landed, double height)
        => Assert.Null(AbandonedReturn.FindReasonToStay(
            Hovering() with { LandedState = landed, HeightAboveHomeMetres = height }));

    [Fact]
    public void FindReasonToStay_AnythingElse_IsNamed()
    {
        (VehicleState Vehicle, string Reason)[] cases =
        [
            (Hovering() with { Autopilot = MavAutopilot.Px4, Mode = "OFFBOARD" },
                "PX4: its own failsafe has acted"),
            (Hovering() with { Autopilot = MavAutopilot.Generic }, "the autopilot is Generic, not ArduPilot"),
            (Hovering() with { IsArmed = false }, "the vehicle is not armed"),
            (Hovering() with { SystemStatus = MavState.Critical }, "the autopilot is in a failsafe (Critical)"),
            (Hovering() with { SystemStatus = MavState.Emergency }, "the autopilot is in a failsafe (Emergency)"),
            (Hovering() with { Mode = "LOITER" }, "its mode is LOITER: another commands it"),
            (Hovering() with { Mode = "RTL" }, "its mode is RTL: another commands it"),
            (Hovering() with { LandedState = MavLandedState.OnGround }, "the vehicle is not in the air"),
            (Hovering() with { LandedState = MavLandedState.Undefined, HeightAboveHomeMetres = 1 },
                "the vehicle is not in the air"),
        ];

        Assert.All(cases, c => Assert.Equal(c.Reason, AbandonedReturn.FindReasonToStay(c.Vehicle)));
    }

    [Theory]
    [InlineData(null, "{ \"isCommanding\": true }", "SERVICE_RESULT is not set")]
    [InlineData("success", "{ \"isCommanding\": true }", "the service ended in order")]
    [InlineData("signal", "{ \"isCommanding\": false }", "does not say that the vehicle was commanded")]
    [InlineData("signal", "{ }", "does not say that the vehicle was commanded")]
    [InlineData("signal", "[true]", "does not say that the vehicle was commanded")]
    [InlineData("signal", "{ \"isComm", "cannot be read")]
    [InlineData("signal", null, "cannot be read")]
    public void FindReasonToStay_ByServiceAndState_NothingIsOpened(string? result, string? state, string expected)
    {
        if (state is not null)
            File.WriteAllText(StateFile, state);

        Assert.Contains(expected, AbandonedRun.FindReasonToStay(result, StateFile));
    }

    [Fact]
    public void FindReasonToStay_ServiceFailedWhileCommanding_IsNone()
    {
        File.WriteAllText(StateFile, "{ \"isCommanding\": true }");

        Assert.Null(AbandonedRun.FindReasonToStay("watchdog", StateFile));
    }

    private static VehicleState Hovering() => new()
    {
        Autopilot = MavAutopilot.Ardupilotmega,
        IsArmed = true,
        Mode = "GUIDED",
        SystemStatus = MavState.Active,
        LandedState = MavLandedState.InAir,
        PositionTime = TimeSpan.Zero,
    };
}
