using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.MissionControl;

public class WholeMissionTests(ITestOutputHelper output)
{
    [Fact]
    public void Mission_NothingGoesWrong_IsFlownToItsEnd()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.Targets.AddRange(
            [(80, -30, DefaultTargetClasses.Red), (120, 20, DefaultTargetClasses.Blue),
                (140, -50, DefaultTargetClasses.Yellow)]);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        output.WriteLine(rig.Story);

        MissionStatus status = rig.Status;
        Assert.Null(status.Aborted);
        Assert.Equal(3, status.Revisits);
        Assert.InRange(status.Coverage, 0.985, 1);
        Assert.Equal(status.Plan!.Lanes.Length / 2, status.LanesFlown);
        Assert.False(rig.Vehicle.IsArmed);
        Assert.InRange(
            Math.Sqrt((rig.Vehicle.North * rig.Vehicle.North) + (rig.Vehicle.East * rig.Vehicle.East)), 0, 2);
        Assert.InRange(rig.Now.TotalSeconds, 100, 420);
        Assert.Equal(
            ["WaitingForVehicle -> Arming", "Arming -> TakingOff", "TakingOff -> InTransit", "InTransit -> Searching"],
            rig.Decisions.Where(d => d.Contains(" -> ", StringComparison.Ordinal)).Take(4).Select(Transition));
        Assert.Equal(
            ["Searching -> Returning", "Returning -> Landing", "Landing -> Done"],
            rig.Decisions.Where(d => d.Contains(" -> ", StringComparison.Ordinal)).Reverse().Take(3).Reverse()
                .Select(Transition));
    }

    [Fact]
    public void Mission_SameSeed_LogsTheSameToTheByte()
    {
        string Fly()
        {
            using var rig = new MissionRig(MissionRig.Mission());
            rig.Vehicle.Targets.Add((80, -30, DefaultTargetClasses.Red));
            rig.RunToEnd();
            return rig.Story;
        }

        string first = Fly();
        Assert.Contains("-> Done", first, StringComparison.Ordinal);
        Assert.Equal(first, Fly());
    }

    [Fact]
    public void Mission_WholeFlight_StaysInsideTheFence()
    {
        using var rig = new MissionRig(
            MissionRig.Mission(area: "[[60,-80],[60,80],[160,80],[160,40],[90,40],[90,-40],[160,-40],[160,-80]]"));
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        SearchPlan plan = rig.Status.Plan!;
        var frame = LocalNedFrame.IgnoringGeoid(plan.Home);
        var fence = new PlanePolygon(
            plan.Fence.Select(c => frame.ToNed(c)).Select(n => new PlanePoint(n.North, n.East)));
        double worst = rig.Vehicle.Path.Min(p => fence.SignedDistance(new PlanePoint(p.North, p.East)));
        output.WriteLine($"nearest to the fence: {worst:0.0} m");
        Assert.InRange(worst, 0, double.PositiveInfinity);
        Assert.InRange(rig.Status.Coverage, 0.985, 1);
    }

    [Fact]
    public void Mission_Lanes_AreFlownStraight()
    {
        using var rig = new MissionRig(MissionRig.Mission(", \"laneHeadingDegrees\": 90"));
        rig.RunUntil(MissionPhase.Searching);
        rig.Run(5);
        rig.Vehicle.North += 4;
        rig.Run(8);
        LocalNedFrame frame = LocalNedFrame.IgnoringGeoid(rig.Status.Plan!.Home);
        double lane = frame.ToNed(rig.Status.Plan.Lanes[0]).North;
        Assert.Equal(lane, rig.Vehicle.North, 1.0);
    }

    [Fact]
    public void Mission_GoTo_IsCommandedOnlyWhenTheTargetChanges()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunToEnd();
        var sent = rig.Vehicle.Commands.Where(c => c.Command.Kind == VehicleCommandKind.GoTo).ToList();
        output.WriteLine($"{sent.Count} in {rig.Now}");
        Assert.InRange(sent.Count, 10, 80);
        for (int i = 1; i < sent.Count; i++)
        {
            VehicleCommand a = sent[i - 1].Command;
            VehicleCommand b = sent[i].Command;
            Assert.False(
                a.Latitude.Radians.Equals(b.Latitude.Radians) && a.Longitude.Radians.Equals(b.Longitude.Radians)
                    && a.Yaw.Radians.Equals(b.Yaw.Radians));
        }
    }

    [Fact]
    public void Mission_Imaging_SearchesBetweenTransitAndReturn()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.InTransit);
        rig.Run(1);
        Assert.Equal(ImagingMode.Off, rig.Vehicle.Imaging.Mode);
        rig.RunUntil(MissionPhase.Searching);
        rig.Run(0.5);
        Assert.Equal(ImagingMode.Search, rig.Vehicle.Imaging.Mode);
        Assert.Equal(488, rig.Vehicle.Imaging.GroundAltitudeAmslMetres, 0.01);
        Assert.Empty(rig.Vehicle.Imaging.Classes);
        Assert.Equal(-Math.PI / 2, rig.Vehicle.Imaging.CameraPitch.Radians, 12);
        rig.RunUntil(MissionPhase.Returning);
        rig.Run(0.5);
        Assert.Equal(ImagingMode.Off, rig.Vehicle.Imaging.Mode);
    }

    [Fact]
    public void Mission_Gimbal_IsTurnedBeforeTheTransit()
    {
        using var rig = new MissionRig(MissionRig.Mission(", \"camera\": {\"gimbal\": true, \"pitchDegrees\": -60}"));
        rig.RunUntil(MissionPhase.Searching);
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.PointCamera));
        Assert.Equal(-Math.PI / 3, rig.Vehicle.Commands.Single(c =>
            c.Command.Kind == VehicleCommandKind.PointCamera).Command.CameraPitch.Radians, 9);
    }

    [Fact]
    public void Revisit_NewTarget_IsFlownOverOnceFromAcrossTheLanes()
    {
        using var rig = new MissionRig(MissionRig.Mission(", \"laneHeadingDegrees\": 90, \"targets\": [\"red\"]"));
        rig.Vehicle.Targets.AddRange([(80, -30, DefaultTargetClasses.Red), (120, 20, DefaultTargetClasses.Blue)]);
        Assert.Equal(MissionPhase.Revisiting, rig.RunUntil(MissionPhase.Revisiting));
        rig.RunUntil(MissionPhase.Searching);
        Assert.Equal(80, rig.Vehicle.North, 2.5);
        Assert.Equal(-30, rig.Vehicle.East, 2.5);
        Assert.Equal(1, Math.Abs(Math.Cos(rig.Vehicle.Yaw)), 6);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(1, rig.Status.Revisits);
        Assert.Single(rig.Decisions, d => d.Contains("-> Revisiting", StringComparison.Ordinal));
    }

    [Fact]
    public void Revisit_NewTarget_IsPassedToTheOtherSideAndBack()
    {
        using var rig = new MissionRig(MissionRig.Mission(", \"laneHeadingDegrees\": 90, \"targets\": [\"red\"]"));
        var frame = LocalNedFrame.IgnoringGeoid(MissionRig.Home);
        rig.Vehicle.Targets.Add((80, -30, DefaultTargetClasses.Red));
        rig.RunUntil(MissionPhase.Revisiting);
        int before = rig.Vehicle.Commands.Count;
        rig.RunUntil(MissionPhase.Searching);
        double[] norths = rig.Vehicle.Commands.Skip(before).Where(c => c.Command.Kind == VehicleCommandKind.GoTo)
            .Select(c => frame.ToNed(GeodeticPosition.FromRadians(
                c.Command.Latitude.Radians, c.Command.Longitude.Radians, MissionRig.Home.AltitudeAmslMetres)).North)
            .Take(3).ToArray();
        Assert.Equal(3, norths.Length);
        Assert.Equal(20, Math.Abs(norths[0] - norths[1]), 1.0);
        Assert.Equal(norths[2], (norths[0] + norths[1]) / 2, 0.01);
        Assert.Equal(80, norths[2], 1.5);
    }

    // At -45 degrees the optical axis meets the ground as far ahead as the vehicle is high; at 90 degrees to the right.
    [Theory]
    [InlineData(-90, 0)]
    [InlineData(-45, 0)]
    [InlineData(-45, 90)]
    [InlineData(-60, -120)]
    public void Revisit_CameraPointsElsewhere_PutsTheTargetIntoTheMiddleOfThePicture(double pitch, double yaw)
    {
        string camera = FormattableString.Invariant(
            $", \"camera\": {{\"pitchDegrees\": {pitch}, \"yawDegrees\": {yaw}}}, \"targets\": [\"red\"]");
        using var rig = new MissionRig(MissionRig.Mission(camera));
        rig.Vehicle.Targets.Add((100, 0, DefaultTargetClasses.Red));
        rig.RunUntil(MissionPhase.Revisiting);
        rig.RunUntil(MissionPhase.Searching);
        double ahead = rig.Vehicle.Height / Math.Tan(-pitch * Math.PI / 180);
        double heading = rig.Vehicle.Yaw + (yaw * Math.PI / 180);
        Assert.Equal(100, rig.Vehicle.North + (ahead * Math.Cos(heading)), 3.5);
        Assert.Equal(0, rig.Vehicle.East + (ahead * Math.Sin(heading)), 3.5);
    }

    [Fact]
    public void Revisit_PassWouldLeaveTheFence_IsFlownFromAnotherDirection()
    {
        using var rig = new MissionRig(MissionRig.Mission(
            ", \"laneHeadingDegrees\": 90, \"revisit\": {\"radiusMetres\": 60}, \"targets\": [\"red\"]"));
        rig.Vehicle.Targets.Add((148, 0, DefaultTargetClasses.Red));
        bool isOutside = false;
        rig.RunUntil(MissionPhase.Revisiting);
        while (rig.Status.Phase == MissionPhase.Revisiting)
        {
            rig.Run(0.5);
            isOutside |= rig.Vehicle.North > 150 + 30;
        }

        Assert.False(isOutside);
        Assert.Equal(1, rig.Status.Revisits);
    }

    [Fact]
    public void Revisit_SwitchedOff_IsNotMade()
    {
        using var rig = new MissionRig(MissionRig.Mission(", \"revisit\": {\"enabled\": false}"));
        rig.Vehicle.Targets.Add((80, -30, DefaultTargetClasses.Red));
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(0, rig.Status.Revisits);
    }

    [Fact]
    public void Revisit_TargetOutsideTheFence_IsLeftAlone()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Vehicle.Tracks.Add(rig.Vehicle.MakeTrack(77, 500, 500, DefaultTargetClasses.Red, 9));
        rig.Vehicle.Targets.Add((80, -30, DefaultTargetClasses.Red));
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(1, rig.Status.Revisits);
        Assert.Contains("track 77 cannot be seen from inside the fence", rig.Story, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("", 1)]
    [InlineData(", \"revisit\": {\"maxWayFraction\": 2}", 3)]
    [InlineData(", \"revisit\": {\"maxWayFraction\": 0}", 0)]
    public void Revisit_WayIsUsedUp_TheRestIsLeftOutAndSaid(string more, int revisits)
    {
        using var rig = new MissionRig(MissionRig.Mission(more));
        rig.Vehicle.Targets.AddRange([
            (80, 0, DefaultTargetClasses.Red), (110, 5, DefaultTargetClasses.Blue),
            (130, -5, DefaultTargetClasses.Yellow),
        ]);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(
            (revisits, 3 - revisits, 0),
            (rig.Status.Revisits, rig.Status.RevisitsLeftOut, rig.Status.RevisitsFailed));
        Assert.Equal(MissionOutcome.Accomplished, rig.Status.Result.Outcome);
        Assert.Equal(
            3 - revisits, rig.Decisions.Count(d => d.Contains("m for revisits", StringComparison.Ordinal)));
    }

    [Fact]
    public void Revisit_OtherHeight_IsFlownThereAndTheLanesAtTheirs()
    {
        using var rig = new MissionRig(
            MissionRig.Mission(", \"revisit\": {\"heightMetres\": 25, \"radiusMetres\": 0}"));
        rig.Vehicle.Targets.Add((80, -30, DefaultTargetClasses.Red));
        rig.RunUntil(MissionPhase.Revisiting);
        rig.RunUntil(MissionPhase.Searching);
        Assert.Equal(25, rig.Vehicle.Height, 2.5);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.InRange(rig.Status.Coverage, 0.985, 1);
    }

    [Fact]
    public void GapPass_CameraMissedALane_FliesOverTheGapsOnly()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Vehicle.CameraSees = false;
        while (rig.Status.LanesFlown < 1)
            rig.Run(0.5);
        rig.Vehicle.CameraSees = true;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        output.WriteLine(rig.Story);
        Assert.Contains(" over gaps", rig.Story, StringComparison.Ordinal);
        Assert.InRange(rig.Status.Coverage, 0.985, 1);
        Assert.InRange(rig.Status.LanesFlown - (rig.Status.Plan!.Lanes.Length / 2), 1, 2);
    }

    [Fact]
    public void GapPass_CameraSeesNothing_EndsAfterTwo()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.CameraSees = false;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal(0, rig.Status.Coverage);
        Assert.Equal(2, rig.Decisions.Count(d => d.Contains("more legs", StringComparison.Ordinal)));
    }

    [Fact]
    public void Status_WholeFlight_IsPostedEverySecond()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Run(1);
        int before = rig.StatusPosts;
        rig.Run(60);
        Assert.InRange(rig.StatusPosts - before, 50, 80);
    }

    [Fact]
    public void NoMission_VehicleThere_CommandsNothing()
    {
        using var rig = new MissionRig(null);
        rig.Run(60);
        rig.Manager.ReturnToLaunch("test", "nothing to abort");
        rig.Run(10);
        Assert.Equal(MissionPhase.NoMission, rig.Status.Phase);
        Assert.Empty(rig.Vehicle.Commands);
    }

    // "   12.345678 mission control: A -> B: why"
    private static string Transition(string line)
    {
        int from = line.IndexOf(": ", StringComparison.Ordinal) + 2;
        return line.Substring(from, line.IndexOf(": ", from, StringComparison.Ordinal) - from);
    }
}
