using System;
using System.IO;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests;
using Rabit.Uav.Tests.Communications;
using Xunit;

namespace UavConsole.Tests.Abandoned;

/// <summary>When a vehicle that a failed flight left behind is asked to return, and when it is left alone.</summary>
public sealed class AbandonedReturnTests : IDisposable
{
    // Written by Mission Control in the middle of a simulated search and at its end.
    private const string Progress = "search.progress.json";
    private const string DoneProgress = "search-done.progress.json";

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
            (Hovering() with { VehicleType = MavType.FixedWing },
                "a FixedWing is no copter: its modes have other numbers"),
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
    [InlineData(null, "SERVICE_RESULT is not set")]
    [InlineData("success", "the service ended in order")]
    public void FindReasonToStay_ServiceDidNotFail_IsNamed(string? result, string expected)
    {
        File.WriteAllText(StateFile, TestData.MissionText(Progress));

        Assert.Contains(expected, AbandonedRun.FindReasonToStay(result, StateFile));
    }

    [Fact]
    public void FindReasonToStay_ServiceFailedWhileCommanding_IsNone()
    {
        File.WriteAllText(StateFile, TestData.MissionText(Progress));

        Assert.Null(AbandonedRun.FindReasonToStay("watchdog", StateFile));
    }

    [Fact]
    public void FindReasonToStay_NotCommanded_IsNamed()
    {
        File.WriteAllText(StateFile, TestData.MissionText(DoneProgress));

        Assert.Contains("does not say that the vehicle was commanded", FindReasonAfterFault());
    }

    // It says that the vehicle was commanded, and none of them is what Mission Control wrote.
    [Fact]
    public void FindReasonToStay_DamagedProgress_IsNamed()
    {
        string whole = TestData.MissionText(Progress);
        string[] damaged =
        [
            string.Empty, "{ \"isCommanding\": true }", whole.Remove(whole.Length / 2),
            TestData.MissionText(DoneProgress).Replace("\"isCommanding\":false", "\"isCommanding\":true"),
        ];

        Assert.All(damaged, text =>
        {
            File.WriteAllText(StateFile, text);
            Assert.Contains("it is not complete or was changed", FindReasonAfterFault());
        });
    }

    [Fact]
    public void FindReasonToStay_NoProgress_IsNamedInOneSentence()
    {
        string? reason = FindReasonAfterFault();

        Assert.Contains("it cannot be read: ", reason);
        Assert.DoesNotContain("..", reason);
    }

    private string? FindReasonAfterFault() => AbandonedRun.FindReasonToStay("signal", StateFile);

    private static VehicleState Hovering() => new()
    {
        VehicleType = MavType.Quadrotor,
        Autopilot = MavAutopilot.Ardupilotmega,
        IsArmed = true,
        Mode = "GUIDED",
        SystemStatus = MavState.Active,
        LandedState = MavLandedState.InAir,
        PositionTime = TimeSpan.Zero,
    };
}
