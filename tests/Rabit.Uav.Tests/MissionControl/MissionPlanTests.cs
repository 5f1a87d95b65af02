using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

public class MissionPlanTests
{
    [Fact]
    public void Parse_ExampleOfTheDocs_HasItsValues()
    {
        MissionPlan plan = MissionPlan.Parse(TestData.MissionText("north-field.json"), "north-field.json");
        Assert.Equal("north field", plan.Name);
        Assert.Equal(4, plan.Area.Length);
        Assert.Equal(47.3982397, plan.Area[0].Latitude.Degrees, 9);
        Assert.Equal(8.5445383, plan.Area[0].Longitude.Degrees, 9);
        Assert.Equal(
            (40, 6, 30, 40),
            (plan.HeightMetres, plan.SpeedMetresPerSecond, plan.LaneSpacingMetres, plan.FenceMarginMetres));
        Assert.Null(plan.LaneHeading);
        Assert.Equal(DefaultTargetClasses.All.ToArray(), plan.Targets.ToArray());
        Assert.Equal(8.5456, plan.Home!.Longitude.Degrees, 9);
        Assert.True(plan.Revisit.IsEnabled);
        Assert.Equal(-Math.PI / 2, plan.CameraPitch.Radians, 12);
        Assert.Equal(0.5, plan.MinBatteryFractionAtStart);
    }

    [Fact]
    public void Parse_OnlyWhatIsNeeded_HasDefaults()
    {
        MissionPlan plan = MissionRig.Mission();
        Assert.Equal("test", plan.Name);
        Assert.Equal((40, 0, false), (plan.FenceMarginMetres, plan.Targets.Length, plan.HasGimbal));
        Assert.Null(plan.Home);
        Assert.Equal((true, null, 10), (plan.Revisit.IsEnabled, plan.Revisit.HeightMetres, plan.Revisit.RadiusMetres));
    }

    [Theory]
    [InlineData("\"fenceMargin\": 40", "fenceMargin is unknown; did you mean fenceMarginMetres?")]
    [InlineData("\"zzz\": 40", "zzz is unknown; there are camera, limits, revisit, name, area, heightMetres")]
    [InlineData("\"camera\": {\"pitch\": 1}", "camera.pitch is unknown")]
    [InlineData("\"camera\": 5", "camera is 5; it must be an object")]
    [InlineData("\"laneHeadingDegrees\": \"north\"", "laneHeadingDegrees is \"north\"; it must be a number")]
    [InlineData("\"laneHeadingDegrees\": 400", "laneHeadingDegrees is 400; it must be -360 to 360")]
    [InlineData("\"heightMetres\": 40", "heightMetres is there twice")]
    [InlineData("\"groundStationLost\": {\"action\": \"land\"}",
        "groundStationLost.action is \"land\"; it must be one of return, hold, continue")]
    [InlineData("\"groundStationLost\": {\"holdAfterSeconds\": 1}",
        "groundStationLost.holdAfterSeconds is 1; it must be 5 to 600")]
    [InlineData("\"groundStationLost\": {\"returnAfterSeconds\": 8}",
        "groundStationLost.returnAfterSeconds is 8; it must be 10 to 3600")]
    [InlineData("\"groundStationLost\": {\"holdAfterSeconds\": \"x\"}",
        "groundStationLost.holdAfterSeconds is \"x\"; it must be a number")]
    [InlineData("\"groundStationLost\": {\"after\": 1}", "groundStationLost.after is unknown")]
    [InlineData("\"name\": 7", "name is 7; it must be a text")]
    [InlineData("\"name\": \"\"", "name must be a line of 1 to 80 characters")]
    [InlineData("\"targets\": [\"red\", \"\"]",
        "targets[1] is \"\"; it must be the name of a target class: 1 to 16 printable ASCII characters")]
    [InlineData("\"targets\": [\"seventeen letters\"]",
        "targets[0] is \"seventeen letters\"; it must be the name of a target class")]
    [InlineData("\"targets\": [5]", "targets[0] is 5; it must be the name of a target class")]
    [InlineData("\"targets\": []", "targets is []; it must name at least one target class")]
    [InlineData("\"targets\": \"red\"", "targets is \"red\"; it must be a list")]
    [InlineData("\"targetMotions\": {\"car\": \"flying\"}",
        "targetMotions.car is \"flying\"; it must be one of standing, walking, vehicle")]
    [InlineData("\"targetMotions\": {\"seventeen letters\": \"walking\"}",
        "targetMotions.seventeen letters is \"walking\"; it must be by the name of a target class")]
    [InlineData("\"targetMotions\": [\"car\"]", "targetMotions is [\"car\"]; it must be an object")]
    [InlineData("\"targetClasses\": {\"seventeen letters\": {\"x\": 1}}",
        "targetClasses.seventeen letters is {\"x\": 1}; it must be by the name of a target class")]
    [InlineData("\"targetClasses\": {\"pad\": 7}", "targetClasses.pad is 7; it must be an object")]
    [InlineData("\"targetClasses\": {\"pad\": {\"colour\": \"red\"}}",
        "targetClasses.pad.colour is \"red\"; it must be sRGB in hexadecimal digits, \"#rrggbb\"")]
    [InlineData("\"targetClasses\": {\"pad\": {\"color\": \"#aabbcc\"}}",
        "targetClasses.pad.color is unknown; did you mean colour?")]
    [InlineData("\"targetClasses\": {\"pad\": {\"marker\": {\"family\": \"QR\"}}}",
        "targetClasses.pad.marker.family is \"QR\"; it must be one of ArUco4x4, AprilTag36h11")]
    [InlineData("\"targetClasses\": {\"pad\": {\"marker\": {\"id\": 3}}}",
        "targetClasses.pad.marker.family is missing")]
    [InlineData("\"targetClasses\": {\"pad\": {\"marker\": 5}}",
        "targetClasses.pad.marker is missing or no object")]
    [InlineData("\"targetClasses\": {\"pad\": {\"marker\": {\"family\": \"ArUco4x4\", \"id\": 1.5}}}",
        "targetClasses.pad.marker.id is 1.5; it must be a whole number")]
    [InlineData("\"targetClasses\": {\"pad\": {\"marker\": {\"family\": \"ArUco4x4\", \"id\": 50}}}",
        "targetClasses: the marker of target class pad has the id 50; ArUco4x4 has 0 to 49")]
    [InlineData("\"targetClasses\": {\"pad\": {\"minSideMetres\": 2}}",
        "targetClasses: MinSideMetres of target class pad is 2 and MaxSideMetres 1.5")]
    [InlineData("\"home\": {\"latitudeDegrees\": 47}", "home.longitudeDegrees is missing")]
    [InlineData("\"home\": {\"latitudeDegrees\": 97, \"longitudeDegrees\": 8}", "home is not a position")]
    [InlineData("\"home\": {\"latitudeDegrees\": 47, \"longitudeDegrees\": 8, \"groundAltitudeAmslMetres\": 99999}",
        "home.groundAltitudeAmslMetres is 99999; it must be -500 to 9000")]
    [InlineData("\"fenceMarginMetres\": 20",
        "fenceMarginMetres is 20; it must be at least 25: lanes end up to half a spacing outside the area")]
    [InlineData("\"requiredCoverage\": 98", "requiredCoverage is 98; it must be 0 to 1")]
    [InlineData("\"fenceMarginMetres\": 501", "fenceMarginMetres is 501; it must be 0 to 500")]
    [InlineData("\"revisit\": {\"enabled\": 1}", "revisit.enabled is 1; it must be true or false")]
    [InlineData(
        "\"revisit\": {\"followSeconds\": -1}", "revisit.followSeconds is -1; it must be 0 to 3600")]
    [InlineData(
        "\"revisit\": {\"maxWayFraction\": -0.1}", "revisit.maxWayFraction is -0.1; it must be 0 to 10")]
    [InlineData("\"revisit\": {\"followSeconds\": \"x\"}", "revisit.followSeconds is \"x\"; it must be a number")]
    [InlineData("\"revisit\": {\"followSeconds\": 1e15}", "revisit.followSeconds is")]
    [InlineData("\"revisit\": {\"heightMetres\": 2}", "revisit.heightMetres is 2; it must be 5 to 120")]
    [InlineData("\"camera\": {\"pitchDegrees\": -91}", "camera.pitchDegrees is -91; it must be -90 to -20")]
    [InlineData("\"limits\": {\"minBatteryFractionAtStart\": 50}",
        "limits.minBatteryFractionAtStart is 50; it must be 0 to 1")]
    public void Parse_OneFault_IsReportedWithPathAndValue(string property, string text)
    {
        MissionPlanException e = Assert.Throws<MissionPlanException>(
            () => MissionPlan.Parse(MissionRig.Text(", " + property), "test"));
        Assert.Contains(text, e.Message, StringComparison.Ordinal);
        Assert.Single(e.Faults);
    }

    [Fact]
    public void Parse_TargetMotions_AreByClass()
    {
        MissionPlan plan = MissionRig.Mission(
            """, "targetMotions": {"person": "walking", "car": "vehicle", "red": "standing"}""");
        Assert.Equal(3, plan.TargetMotions.Count);
        Assert.Equal(TargetMotion.Walking, plan.TargetMotions[new TargetClassName("person")]);
        Assert.Equal(TargetMotion.Vehicle, plan.TargetMotions[new TargetClassName("car")]);
        Assert.Equal(TargetMotion.Standing, plan.TargetMotions[new TargetClassName("red")]);
    }

    [Fact]
    public void ForImageProcessing_ClassesOfTheMission_ComeBesideOrInPlaceOfTheOptions()
    {
        var options = new UavOptions
        {
            Mission = MissionRig.Mission(
                """
                , "targetClasses": {
                  "pad": { "marker": { "family": "AprilTag36h11", "id": 7 }, "minSideMetres": 0.4, "maxSideMetres": 0.6 },
                  "any": { "marker": { "family": "ArUco4x4" } },
                  "red": { "colour": "#C01020", "maxSideMetres": 4, "minAspect": 1.5, "maxAspect": 3 }
                }
                """),
        };
        ImmutableArray<TargetClass> classes = ManagerOptions.ForImageProcessing(options).TargetClasses;
        Assert.Equal(
            ["orange", "blue", "yellow", "magenta", "pad", "any", "red"], classes.Select(c => c.Name.ToString()));
        Assert.Equal((MarkerFamily.AprilTag36h11, 7), (classes[4].Marker!.Family, classes[4].Marker!.Id));
        Assert.Equal((0.4, 0.6), (classes[4].MinSideMetres, classes[4].MaxSideMetres));
        Assert.Null(classes[5].Marker!.Id);
        Assert.Equal((0xC0, 0x10, 0x20), (classes[6].Colour!.Red, classes[6].Colour!.Green, classes[6].Colour!.Blue));
        Assert.Equal((0.6, 4, 1.5, 3),
            (classes[6].MinSideMetres, classes[6].MaxSideMetres, classes[6].MinAspect, classes[6].MaxAspect));
        Assert.Equal(TargetClass.Defaults, options.Imaging.TargetClasses);
        Assert.IsType<CombinedTargetDetector>(ManagerOptions.ForImageProcessing(options).CreateDetector());
    }

    [Fact]
    public void ForSensorFusion_MotionsOfMissionAndOptions_AreJoinedOrRefused()
    {
        var car = new TargetClassName("car");
        var options = new UavOptions
        {
            Mission = MissionRig.Mission(""", "targetMotions": {"person": "walking", "car": "vehicle"}"""),
        };
        options.Fusion.TargetMotions = options.Fusion.TargetMotions.Add(car, TargetMotion.Vehicle);
        Assert.Equal(2, ManagerOptions.ForSensorFusion(options).TargetMotions.Count);
        Assert.Single(options.Fusion.TargetMotions);
        Assert.Empty(ManagerOptions.FindContradictions(options));

        options.Fusion.TargetMotions = options.Fusion.TargetMotions.SetItem(car, TargetMotion.Walking);
        Assert.Equal(
            "targetMotions of the mission has car Vehicle, and Fusion.TargetMotions Walking",
            Assert.Single(ManagerOptions.FindContradictions(options)));
    }

    [Fact]
    public void Parse_FileOfTheOldForm_IsRefusedWithEveryNewName()
    {
        const string Old = ", \"home\": {\"lat\": 47.3977, \"lon\": 8.5456}, \"secondLook\": {\"enabled\": true, "
            + "\"radiusMetres\": 10}, "
            + "\"limits\": {\"minBatteryToStart\": 0.5}";
        MissionPlanException e = Assert.Throws<MissionPlanException>(
            () => MissionPlan.Parse(MissionRig.Text(Old), "test"));
        Assert.Equal(
            [
                "home.lat is of an older form of the file; it is home.latitudeDegrees now",
                "home.lon is of an older form of the file; it is home.longitudeDegrees now",
                "limits.minBatteryToStart is of an older form of the file; it is limits.minBatteryFractionAtStart now",
                "secondLook is of an older form of the file; it is revisit now",
            ],
            e.Faults.OrderBy(f => f, StringComparer.Ordinal));
    }

    [Theory]
    [InlineData("[[0,0],[100,0]]", "area has 2 corners; it must have 3 to 50")]
    [InlineData("[[0,0],[100,100],[100,0],[0,100]]", "area crosses itself")]
    [InlineData("[[0,0],[100,0],[50,0]]", "area crosses itself")]
    [InlineData("[[0,0],[5,0],[5,5],[0,5]]", "area has 25 m2; it must have 100 to 4000000")]
    [InlineData("[[0,0],[3000,0],[3000,3000],[0,3000]]", "area has 8998")]
    [InlineData("[[0,0],[9000,0],[9000,100]]", "area[1] is 8999 m from area[0]; corners must be within 5000 m of it")]
    [InlineData("[[0,0],[100,0],[100,100],[0,0]]",
        "area[3] and area[0] are the same position; the first corner is not repeated")]
    public void Parse_AreaThatCannotBeSearched_IsRefused(string area, string text)
    {
        MissionPlanException e = Assert.Throws<MissionPlanException>(() => MissionRig.Mission(area: area));
        Assert.Contains(text, e.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("", "it is not JSON")]
    [InlineData("{\"area\": [", "it is not JSON: line 1")]
    [InlineData("{\"camera\": {\"mode\": [1, \"\\ud800\"]}}",
        "it is not JSON: camera.mode[1] is a text that cannot be read")]
    [InlineData("{\"\\ud800\": 1}", "it is not JSON: (a name) is a text that cannot be read")]
    [InlineData("[]", "it must be an object")]
    [InlineData("null", "it must be an object")]
    [InlineData("{}",
        "area is missing; heightMetres is missing; speedMetresPerSecond is missing; laneSpacingMetres is missing")]
    [InlineData("{\"area\": [[1,2],[3],[\"a\",4],[91,0]], \"heightMetres\": 40, \"speedMetresPerSecond\": 6, "
        + "\"laneSpacingMetres\": 30}",
        "area[1] is [3]; it must be [latitude, longitude] in degrees; area[2] is [\"a\",4]; it must be [latitude, "
            + "longitude] in degrees; area[3] is [91,0]")]
    [InlineData("{\"area\": null, \"heightMetres\": 1e999}",
        "area is missing; heightMetres is 1e999; it must be a number")]
    public void Parse_NoMission_IsRefusedWithAllFaults(string json, string text)
    {
        MissionPlanException e = Assert.Throws<MissionPlanException>(() => MissionPlan.Parse(json, "bad.json"));
        Assert.StartsWith("Mission 'bad.json': ", e.Message, StringComparison.Ordinal);
        Assert.Contains(text, e.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Parse_DeepOrHugeText_IsRefused()
    {
        Assert.Throws<MissionPlanException>(
            () => MissionPlan.Parse(string.Concat(Enumerable.Repeat("[", 5000)), "deep"));
        Assert.Throws<MissionPlanException>(() => MissionPlan.Parse(new string(' ', 1_000_001), "huge"));
    }

    [Fact]
    public void WithTargets_FurtherClasses_AreDeclaredAndSearchedForBesideItsOwn()
    {
        MissionPlan plan = new()
        {
            Name = "pads",
            Targets = [DefaultTargetClasses.Red, new TargetClassName("pad")],
            TargetClasses = [new TargetClass("pad") { MinSideMetres = 0.3 }],
        };
        TargetClass car = new("car");
        MissionPlan more = plan.WithTargets([new TargetClass("pad"), car, car]);

        Assert.Equal("pads", more.Name);
        Assert.Equal(["red", "pad", "car"], more.Targets.Select(t => t.ToString()));
        Assert.Equal(["pad", "car"], more.TargetClasses.Select(c => c.Name.ToString()));
        Assert.Equal(0.3, more.TargetClasses[0].MinSideMetres);
        Assert.Equal(2, plan.Targets.Length);
        Assert.Empty(new MissionPlan().WithTargets([car]).Targets);   // all
    }

    [Fact]
    public void WithGimbal_FixedCamera_IsPointedAndTheRestIsTheSame()
    {
        MissionPlan plan = new() { Name = "pads", CameraPitch = Angle.FromDegrees(-60) };
        MissionPlan pointed = plan.WithGimbal();

        Assert.True(pointed.HasGimbal);
        Assert.Equal("pads", pointed.Name);
        Assert.Equal(-60, pointed.CameraPitch.Degrees, 9);
        Assert.False(plan.HasGimbal);
    }

    [Fact]
    public void Options_MissionThatCannotBeFlown_IsRefusedWithAllFaults()
    {
        ArgumentException e = Assert.Throws<ArgumentException>(() => new MissionControlManager(new MissionControlOptions
        {
            Mission = new MissionPlan { HeightMetres = 500, SpeedMetresPerSecond = 6, LaneSpacingMetres = 30 },
            CoverageGoal = 2,
        }));
        Assert.Contains("CoverageGoal is 2", e.Message, StringComparison.Ordinal);
        Assert.Contains("Mission: area has 0 corners", e.Message, StringComparison.Ordinal);
        Assert.Contains("Mission: heightMetres is 500", e.Message, StringComparison.Ordinal);
    }
}
