using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.Preflight;
using Rabit.Uav.Tests.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.Preflight;

/// <summary>Each line of the checklist, by what passes, warns, fails and is not known.</summary>
public sealed class PreflightRulesTests
{
    [Theory]
    [InlineData(MavAutopilot.Ardupilotmega)]
    [InlineData(MavAutopilot.Px4)]
    public void Evaluate_AllAsWanted_Passes(MavAutopilot make)
    {
        PreflightReport report = PreflightChecklist.Evaluate(PreflightCases.Facts(make));

        Assert.All(report.Lines, l => Assert.Equal(PreflightResult.Pass, l.Result));
        Assert.True(report.Passes);
        Assert.Null(report.FindRefusal());
    }

    [Theory]
    [InlineData("FS_GCS_ENABLE", 0, PreflightResult.Fail, "0 (off)")]
    [InlineData("FS_GCS_ENABLE", 5, PreflightResult.Warn, "5 (land)")]
    [InlineData("FS_GCS_TIMEOUT", 120, PreflightResult.Warn, "120 s")]
    [InlineData("MAV_GCS_SYSID", 1, PreflightResult.Fail, "1")]
    [InlineData("FS_THR_ENABLE", 0, PreflightResult.Fail, "0 (off)")]
    [InlineData("FS_EKF_ACTION", 0, PreflightResult.Fail, "0 (report only)")]
    [InlineData("FS_EKF_ACTION", 2, PreflightResult.Warn, "2 (ALT_HOLD)")]
    [InlineData("FS_OPTIONS", 20, PreflightResult.Warn, "20 (bit 2 set)")]
    [InlineData("BATT_LOW_VOLT", 0, PreflightResult.Fail, "0 V")]
    [InlineData("BATT_LOW_VOLT", 12.5, PreflightResult.Fail, "12.5 V")]
    [InlineData("BATT_LOW_VOLT", 1, PreflightResult.Fail, "1 V")]
    [InlineData("BATT_LOW_VOLT", 8.9, PreflightResult.Fail, "8.9 V")]
    [InlineData("BATT_LOW_VOLT", 9.6, PreflightResult.Warn, "9.6 V")]
    [InlineData("BATT_LOW_VOLT", 9.9, PreflightResult.Pass, "9.9 V")]
    [InlineData("BATT_FS_LOW_ACT", 0, PreflightResult.Fail, "0 (none)")]
    [InlineData("BATT_FS_LOW_ACT", 1, PreflightResult.Fail, "1 (land)")]
    [InlineData("BATT_FS_LOW_ACT", 3, PreflightResult.Pass, "3 (SmartRTL or RTL)")]
    [InlineData("BATT_FS_CRT_ACT", 0, PreflightResult.Warn, "0 (none)")]
    [InlineData("BATT_FS_CRT_ACT", 5, PreflightResult.Fail, "5 (terminate)")]
    [InlineData("GUID_TIMEOUT", 30, PreflightResult.Warn, "30 s")]
    [InlineData("FENCE_ENABLE", 0, PreflightResult.Warn, "0 (off)")]
    [InlineData("FENCE_ACTION", 0, PreflightResult.Warn, "0 (report only)")]
    [InlineData("FENCE_MARGIN", 0, PreflightResult.Warn, "0 m")]
    public void Judge_ArdupilotParameter_IsByItsValue(
        string name, double value, PreflightResult expected, string text)
    {
        PreflightLine line = PreflightCases.Facts().With(name, value).Line(name);

        Assert.Equal((expected, text), (line.Result, line.Value));
        Assert.Equal(expected != PreflightResult.Pass, line.HowToSet.Length > 0);
    }

    [Theory]
    [InlineData("COM_OF_LOSS_T", 30, PreflightResult.Fail, "30 s")]
    [InlineData("COM_OBL_RC_ACT", 0, PreflightResult.Fail, "0 (POSCTL)")]
    [InlineData("COM_OBL_RC_ACT", 5, PreflightResult.Pass, "5 (hold)")]
    [InlineData("COM_OBL_RC_ACT", 4, PreflightResult.Warn, "4 (land)")]
    [InlineData("COM_RCL_EXCEPT", 4, PreflightResult.Warn, "4 (bit 2 set)")]
    [InlineData("COM_RC_OVERRIDE", 1, PreflightResult.Warn, "1 (bit 1 not set)")]
    [InlineData("COM_RC_IN_MODE", 4, PreflightResult.Warn, "4 (none)")]
    [InlineData("NAV_RCL_ACT", 0, PreflightResult.Fail, "0 (off)")]
    [InlineData("NAV_DLL_ACT", 0, PreflightResult.Warn, "0 (off)")]
    [InlineData("NAV_DLL_ACT", 6, PreflightResult.Fail, "6 (disarm)")]
    [InlineData("COM_LOW_BAT_ACT", 0, PreflightResult.Fail, "0 (warning)")]
    [InlineData("COM_LOW_BAT_ACT", 2, PreflightResult.Warn, "2 (land when critical)")]
    [InlineData("GF_ACTION", 4, PreflightResult.Fail, "4 (terminate)")]
    public void Judge_Px4Parameter_IsByItsValue(string name, double value, PreflightResult expected, string text)
    {
        PreflightLine line = PreflightCases.Facts(MavAutopilot.Px4).With(name, value).Line(name);

        Assert.Equal((expected, text), (line.Result, line.Value));
    }

    [Theory]
    [InlineData(MavAutopilot.Ardupilotmega)]
    [InlineData(MavAutopilot.Px4)]
    public void Judge_FailsafeNotAnswered_Fails(MavAutopilot make)
    {
        PreflightFacts facts = PreflightCases.Facts(make);
        facts.Parameters = new AutopilotParameters { IsComplete = true };

        PreflightLine[] lines = PreflightChecklist.Evaluate(facts).Lines
            .Where(l => PreflightRules.All.First(r => r.Name == l.Name).Autopilot is null).ToArray();
        PreflightLine[] parameters = PreflightChecklist.Evaluate(facts).Lines.Except(lines)
            .Where(l => l.Name is not ("GUID_TIMEOUT" or "FENCE_MARGIN" or "return-height")).ToArray();

        Assert.InRange(parameters.Length, 9, 20);
        Assert.All(parameters, l => Assert.Equal(
            (PreflightResult.Fail, "unknown: the autopilot did not answer"), (l.Result, l.Value)));
    }

    [Theory]
    [InlineData("RTL_ALT_M", 29, PreflightResult.Fail, "29 m")]
    [InlineData("RTL_ALT_M", 30, PreflightResult.Pass, "30 m")]
    [InlineData("RTL_ALT_M", 0, PreflightResult.Fail, "0 m")]
    public void Judge_ReturnHeight_IsByTheObstacles(string name, double value, PreflightResult expected, string text)
    {
        PreflightLine line = PreflightCases.Facts().With(name, value).Line("return-height");

        Assert.Equal((expected, text), (line.Result, line.Value));
    }

    [Theory]
    [InlineData(29, 5, PreflightResult.Fail)]
    [InlineData(30, 5, PreflightResult.Pass)]
    [InlineData(34, 25, PreflightResult.Fail)]
    [InlineData(35, 25, PreflightResult.Pass)]
    public void Judge_ReturnHeight_IsByTheHigherOfObstaclesAndTerrain(
        double value, double hillMetres, PreflightResult expected)
    {
        // North of home and beside the area: a return may lead over it.
        PreflightFacts facts = PreflightCases.Facts(options: o =>
        {
            o.Terrain = TestTerrain.Around(
                PreflightCases.Place, (n, e) => n is > 40 and < 90 && e is > -90 and < -40 ? hillMetres : 0);
            o.SearchArea =
            [
                GeodeticPosition.FromDegrees(47.3985, 8.5450, 488), GeodeticPosition.FromDegrees(47.3990, 8.5450, 488),
                GeodeticPosition.FromDegrees(47.3990, 8.5460, 488),
            ];
            o.FenceMarginMetres = 50;
        }).With("RTL_ALT_M", value);

        PreflightLine line = facts.Line("return-height");
        Assert.Equal(
            (expected, $"{value} m, terrain up to {hillMetres} m: {hillMetres + 10} m or more"),
            (line.Result, line.Value));
    }

    [Fact]
    public void Judge_ReturnHeightBelowTerrainWithoutObstacles_Fails()
    {
        PreflightFacts facts = PreflightCases.Facts(options: o =>
        {
            o.ObstacleHeightMetres = null;
            o.Terrain = TestTerrain.Around(PreflightCases.Place, (n, _) => n > 50 ? 35 : 0);
            o.SearchArea = [GeodeticPosition.FromDegrees(47.3990, 8.5450, 488)];
        });

        Assert.Equal(PreflightResult.Fail, facts.Line("return-height").Result);
        Assert.Equal(PreflightResult.Warn, facts.With("RTL_ALT_M", 60).Line("return-height").Result);
    }

    [Theory]
    [InlineData(45, PreflightResult.Pass)]
    [InlineData(46, PreflightResult.Fail)]
    public void Judge_ReturnHeightInAGroup_IsBelowTheNextLayer(double value, PreflightResult expected)
    {
        PreflightLine line = PreflightCases.Facts(options: o => o.MaxReturnHeightMetres = 45)
            .With("RTL_ALT_M", value).Line("return-height");

        Assert.Equal((expected, $"{value} m, 45 m or less in the group"), (line.Result, line.Value));
    }

    [Fact]
    public void Judge_OldNames_AreKnownWithTheirUnits()
    {
        PreflightFacts facts = PreflightCases.Facts();
        facts.Parameters = PreflightCases.Parameters(
            MavAutopilot.Ardupilotmega, ("RTL_ALT_M", null), ("RTL_ALT", 1500), ("MAV_GCS_SYSID", null),
            ("SYSID_MYGCS", 255));

        Assert.Equal("15 m by RTL_ALT", facts.Line("return-height").Value);
        Assert.Equal((PreflightResult.Pass, "255 by SYSID_MYGCS"),
            (facts.Line("MAV_GCS_SYSID").Result, facts.Line("MAV_GCS_SYSID").Value));
    }

    [Fact]
    public void Judge_ReturnHeightWithoutObstacles_Warns()
    {
        PreflightLine line = PreflightCases.Facts(options: o => o.ObstacleHeightMetres = null).Line("return-height");

        Assert.Equal(PreflightResult.Warn, line.Result);
        Assert.Contains("obstacleHeightMetres", line.HowToSet);
    }

    [Fact]
    public void FindChange_Bits_KeepTheOthers()
    {
        PreflightFacts facts = PreflightCases.Facts(MavAutopilot.Px4).With("COM_RC_OVERRIDE", 1);
        ParameterRule rule = PreflightRules.ParametersOf(MavAutopilot.Px4).Single(r => r.Name == "COM_RC_OVERRIDE");

        Assert.Equal(("COM_RC_OVERRIDE", 3.0), rule.FindChange(facts));
        Assert.Equal("set it to a value with 2 (bit 1 set), or give --set-failsafes", rule.HowToSet);
    }

    [Fact]
    public void FindChange_WhatPasses_IsNotWritten()
    {
        PreflightFacts facts = PreflightCases.Facts().With("BATT_FS_LOW_ACT", 3);

        Assert.All(
            PreflightRules.ParametersOf(MavAutopilot.Ardupilotmega), r => Assert.Null(r.FindChange(facts)));
    }

    // Copter's BATT_FS_LOW_ACT 2 is a return, Plane's a landing: nothing of it is judged, or written.
    [Fact]
    public void Judge_PlaneOfArdupilot_IsNotThatOfCopter()
    {
        PreflightFacts facts = PreflightCases.Facts();
        facts.Vehicle = facts.Vehicle with { VehicleType = MavType.FixedWing };
        PreflightReport report = PreflightChecklist.Evaluate(facts);
        string[] names = report.Lines.Select(l => l.Name).ToArray();
        Assert.DoesNotContain("BATT_FS_LOW_ACT", names);
        Assert.DoesNotContain("return-height", names);
        Assert.Equal(PreflightResult.Fail, report.Lines.Single(l => l.Name == "plane-failsafes").Result);
        Assert.Contains("circles there", report.WhenComputerFails, StringComparison.Ordinal);

        facts.Vehicle = facts.Vehicle with { VehicleType = MavType.Quadrotor };
        Assert.DoesNotContain(PreflightChecklist.Evaluate(facts).Lines, l => l.Name == "plane-failsafes");
    }

    [Fact]
    public void FindChange_WrittenValue_Passes()
    {
        foreach (MavAutopilot make in new[] { MavAutopilot.Ardupilotmega, MavAutopilot.Px4 })
        {
            PreflightFacts facts = PreflightCases.Facts(make);
            Assert.All(
                PreflightRules.ParametersOf(make).Where(r => r.Wanted is not null),
                r => Assert.Equal(PreflightResult.Pass, r.Test.Judge(r.Test.Change(0, r.Wanted!.Value), facts)));
        }
    }

    [Fact]
    public void Names_OfRules_AreOneWordEach()
    {
        Assert.All(PreflightRules.Names, n => Assert.DoesNotContain(' ', n));
        Assert.All(PreflightRules.All, r => Assert.True(
            r.Pass.Length > 0 && r.Reason.Length > 0 && (r.Warn.Length > 0 || r.Fail.Length > 0), r.Name));
    }
}
