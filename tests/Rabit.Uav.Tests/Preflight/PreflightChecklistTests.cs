using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.Preflight;
using Xunit;

namespace Rabit.Uav.Tests.Preflight;

/// <summary>The lines about vehicle, mission and computer; overriding; what happens when the computer fails.</summary>
public sealed class PreflightChecklistTests
{
    private static readonly (string Name, Action<PreflightFacts> Spoil, PreflightResult Result, string Text)[] Spoilt =
    [
        ("link", f => Change(f, v => v with { IsConnected = false }), PreflightResult.Fail, "no autopilot connected"),
        ("link", f => Change(f, v => v with { LastHeartbeatTime = TimeSpan.FromSeconds(96) }), PreflightResult.Fail,
            "no heartbeat for 3 s"),
        ("link", f => f.FramesMissing = 200, PreflightResult.Warn, "16.7 % of the frames missing"),
        ("position", f => Change(f, v => v with { GpsFix = GpsFixType.Type2dFix }), PreflightResult.Fail,
            "Type2dFix, 12 satellites"),
        ("position", f => Change(f, v => v with { GpsTime = null }), PreflightResult.Fail, "no fix reported"),
        ("position", f => Change(f, v => v with { PositionTime = TimeSpan.FromSeconds(90) }), PreflightResult.Fail,
            "Type3dFix, 12 satellites, but no position"),
        ("hdop", f => f.Navigation = f.Navigation with { HorizontalDilution = 2.5 }, PreflightResult.Warn, "2.50"),
        ("hdop", f => f.Navigation = default, PreflightResult.Unknown, "not reported"),
        ("estimator", f => f.Navigation = f.Navigation with { EstimatorFault = "no height" }, PreflightResult.Fail,
            "no height"),
        ("estimator", f => f.Navigation = default, PreflightResult.Unknown, "not reported"),
        ("home", f => f.Navigation = f.Navigation with { Home = GeodeticPosition.FromDegrees(47.3986, 8.5456, 488) },
            PreflightResult.Warn, "100 m from the vehicle"),
        ("home", f => f.Navigation = default, PreflightResult.Unknown, "not reported"),
        ("battery", f => Change(f, v => v with { BatteryRemaining = 0.3 }), PreflightResult.Fail,
            "30 %, 12.4 V; 50 % are needed"),
        ("battery", f => Change(f, v => v with { BatteryRemaining = double.NaN }), PreflightResult.Fail,
            "remaining charge not known, 12.4 V"),
        ("battery", f =>
            {
                f.Options.AllowsUnknownBattery = true;
                Change(f, v => v with { BatteryRemaining = double.NaN });
            },
            PreflightResult.Warn, "remaining charge not known, 12.4 V"),
        ("battery", f => Change(f, v => v with { BatteryTime = null }), PreflightResult.Fail,
            "remaining charge not known"),
        ("picture", f => f.Imaging = default, PreflightResult.Fail, "no camera"),
        ("picture", f => f.Imaging = new ImagingStatus { HasCamera = true }, PreflightResult.Fail, "no picture yet"),
        ("picture", f => f.Imaging = f.Imaging with { LastFrameTime = TimeSpan.FromSeconds(80) },
            PreflightResult.Fail, "20 s ago"),
        ("clock", f => Change(f, v => v with { GpsUtcMicroseconds = 1_699_999_000_000_000 }), PreflightResult.Warn,
            "17 min off the satellites' time"),
        ("clock", f => Change(f, v => v with { UtcTime = null }), PreflightResult.Unknown,
            "no time of satellites to compare with"),
        ("setup", f => f.Parameters = new AutopilotParameters
            {
                IsComplete = true, Setup = AutopilotSetupState.Failed, SetupText = "FS_GCS_ENABLE is not confirmed",
            },
            PreflightResult.Fail, "FS_GCS_ENABLE is not confirmed"),
    ];

    [Fact]
    public void Judge_LinesOfTheVehicle_AreByTheirFacts() => Assert.All(Spoilt, spoilt =>
    {
        PreflightFacts facts = PreflightCases.Facts();
        spoilt.Spoil(facts);

        PreflightLine line = facts.Line(spoilt.Name);

        Assert.Equal((spoilt.Name, spoilt.Result, spoilt.Text), (line.Name, line.Result, line.Value));
        Assert.Equal(spoilt.Result != PreflightResult.Unknown, line.HowToSet.Length > 0);
    });

    [Fact]
    public void Judge_Disk_IsByWhatIsFree()
    {
        Assert.Equal((PreflightResult.Fail, "0 MB free"), Result(free: 5));
        Assert.Equal((PreflightResult.Pass, "100 MB free"), Result(free: 100_000_000));
        Assert.Equal((PreflightResult.Unknown, "not determined"), Result(free: null));

        static (PreflightResult, string) Result(long? free)
        {
            PreflightFacts facts = PreflightCases.Facts();
            facts.Computer = PreflightCases.Computer(free);
            return (facts.Line("disk").Result, facts.Line("disk").Value);
        }
    }

    [Fact]
    public void Judge_MissionWithoutCamera_NeedsNoPicture()
    {
        PreflightFacts facts = PreflightCases.Facts(options: o => o.RequiresCamera = false);
        facts.Imaging = default;

        Assert.Equal("no camera needed", facts.Line("picture").Value);
    }

    [Fact]
    public void Evaluate_LineThatFails_RefusesUnlessOverriddenByName()
    {
        PreflightFacts facts = PreflightCases.Facts().With("BATT_FS_LOW_ACT", 0);

        PreflightReport report = PreflightChecklist.Evaluate(facts);

        Assert.False(report.Passes);
        Assert.Equal("pre-flight checklist: BATT_FS_LOW_ACT (0 (none))", report.FindRefusal());
        Assert.Equal(
            "fail BATT_FS_LOW_ACT: 0 (none); set it to 2 (RTL), or give --set-failsafes",
            report.Lines.Single(l => l.Refuses).ToString());

        facts = PreflightCases.Facts(options: o => o.Overrides = ["BATT_FS_LOW_ACT"]).With("BATT_FS_LOW_ACT", 0);
        report = PreflightChecklist.Evaluate(facts);
        Assert.True(report.Passes);
        Assert.True(report.Lines.Single(l => l.Name == "BATT_FS_LOW_ACT").IsOverridden);
    }

    [Fact]
    public void Evaluate_ParametersBeingRead_RefusesAndIsNoResult()
    {
        PreflightFacts facts = PreflightCases.Facts();
        facts.Parameters = AutopilotParameters.None;

        PreflightReport report = PreflightChecklist.Evaluate(facts);

        Assert.False(report.Passes);
        Assert.Equal("pre-flight checklist: the parameters of the autopilot are being read", report.FindRefusal());
        Assert.Equal("being read", report.Lines.Single(l => l.Name == "FS_GCS_ENABLE").Value);
    }

    [Fact]
    public void Evaluate_OtherMake_HasTheLinesOfTheVehicleOnly()
    {
        PreflightReport report = PreflightChecklist.Evaluate(PreflightCases.Facts(MavAutopilot.Generic));

        Assert.True(report.Passes);
        Assert.Equal(11, report.Lines.Length);
    }

    [Fact]
    public void Overrides_NameThatNoLineHas_IsRefusedWithAllNames()
    {
        var options = new PreflightOptions { Overrides = ["BATT_FS_LOW"] };

        string fault = Assert.Single(options.FindFaults());

        Assert.StartsWith("Overrides has 'BATT_FS_LOW', which no line of the pre-flight checklist has; there are link,",
            fault);
        Assert.Contains("BATT_FS_LOW_ACT", fault);
    }

    [Theory]
    [InlineData(1, "heartbeats run through this computer FS_GCS_ENABLE 1 (RTL) acts 5 s after its last heartbeat")]
    [InlineData(0, "run through this computer it hovers in GUIDED until BATT_FS_LOW_ACT 2 (RTL) acts, since")]
    public void WhenComputerFails_Ardupilot_IsByTheGroundStation(double enable, string expected)
    {
        string text = PreflightChecklist.Evaluate(PreflightCases.Facts().With("FS_GCS_ENABLE", enable))
            .WhenComputerFails;

        Assert.Contains(expected, text);
        Assert.EndsWith(
            "with a ground station on its own radio, or none, it hovers in GUIDED until BATT_FS_LOW_ACT 2 (RTL) acts",
            text);
    }

    [Fact]
    public void WhenComputerFails_Px4_IsByTheLossOfSetPoints()
        => Assert.StartsWith(
            "COM_OBL_RC_ACT 3 (return) acts 0.5 s after the last set-point",
            PreflightChecklist.Evaluate(PreflightCases.Facts(MavAutopilot.Px4)).WhenComputerFails);

    private static void Change(PreflightFacts facts, Func<VehicleState, VehicleState> change)
        => facts.Vehicle = change(facts.Vehicle);
}
