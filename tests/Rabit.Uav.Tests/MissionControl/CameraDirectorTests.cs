using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>A gimbal is pointed at a target that is followed, and then as the mission says again.</summary>
public sealed class CameraDirectorTests
{
    private const double MissionPitch = -80;

    [Fact]
    public void Follow_Gimbal_IsPointedAtTheTargetAndThenAsTheMissionSays()
    {
        using MissionRig rig = Follow(gimbal: true);
        int before = rig.Vehicle.Count(VehicleCommandKind.PointCamera);
        Assert.Equal(1, before);   // on the way to the area
        rig.Run(6);
        VehicleCommand[] pointed = Pointed(rig).Skip(before).ToArray();
        Assert.InRange(pointed.Length, 3, 30);   // at most one in each tick of 0.2 s
        Assert.All(pointed, c => Assert.Equal(GimbalFrame.Heading, c.GimbalFrame));
        Assert.All(pointed, c => Assert.InRange(c.CameraPitch.Degrees, -90, -50));
        Assert.Contains(pointed, c => c.CameraPitch.Degrees > MissionPitch + 5);
        CheckDirection(rig);

        Assert.Equal(MissionPhase.Searching, rig.RunUntil(MissionPhase.Searching));
        CheckRestored(rig);
    }

    [Fact]
    public void Follow_FixedCamera_NothingIsSent()
    {
        using MissionRig rig = Follow(gimbal: false);
        rig.Run(6);
        Assert.Equal(0, rig.Vehicle.Count(VehicleCommandKind.PointCamera));
    }

    [Fact]
    public void Revisit_StandingTarget_GimbalStays()
    {
        using MissionRig rig = Open(gimbal: true);
        rig.Vehicle.Targets.Add((80, -30, DefaultTargetClasses.Blue));
        Assert.Equal(MissionPhase.Revisiting, rig.RunUntil(MissionPhase.Revisiting));
        Assert.Equal(MissionPhase.Searching, rig.RunUntil(MissionPhase.Searching));
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.PointCamera));
    }

    [Fact]
    public void Follow_OperatorReturns_GimbalIsAsTheMissionSaysWhileItReturns()
    {
        using MissionRig rig = Follow(gimbal: true);
        rig.Run(4);
        rig.Manager.ReturnToLaunch("test", "asked to");
        Assert.Equal(MissionPhase.Returning, rig.RunUntil(MissionPhase.Returning, 1));
        CheckRestored(rig);
    }

    // The vehicle is commanded as before; once the gimbal takes commands again it is restored.
    [Fact]
    public void Follow_GimbalRefuses_TheVehicleGoesOnAndTheGimbalIsRestored()
    {
        using MissionRig rig = Follow(gimbal: true);
        rig.Run(3);
        rig.Vehicle.Refuses = c => c.Kind == VehicleCommandKind.PointCamera ? VehicleCommandOutcome.TimedOut : null;
        int goals = rig.Vehicle.Count(VehicleCommandKind.GoTo);
        Assert.Equal(MissionPhase.Searching, rig.RunUntil(MissionPhase.Searching));
        Assert.True(rig.Vehicle.Count(VehicleCommandKind.GoTo) > goals + 5);
        rig.Run(3);
        rig.Vehicle.Refuses = static _ => null;
        CheckRestored(rig);
        Assert.Single(rig.Decisions, d => d.Contains("the camera is not pointed", StringComparison.Ordinal));
    }

    [Fact]
    public void Follow_CommandTakenAway_GimbalIsLeftToThePilot()
    {
        using MissionRig rig = Follow(gimbal: true);
        rig.Run(3);
        rig.Vehicle.TakeOver("the pilot");
        rig.Run(1);
        int before = rig.Vehicle.Commands.Count;
        rig.Run(10);
        Assert.Equal(before, rig.Vehicle.Commands.Count);
    }

    // What it was commanded to is not where it points while it turns.
    [Fact]
    public void Follow_GimbalDoesNotReport_StaysAsTheMissionSays()
    {
        using MissionRig rig = Follow(gimbal: true, reports: _ => false);
        rig.Run(6);
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.PointCamera));
    }

    [Fact]
    public void Follow_GimbalFallsSilent_IsPointedAsTheMissionSays()
    {
        double silentFrom = double.PositiveInfinity;
        using MissionRig rig = Follow(gimbal: true, reports: now => now.TotalSeconds < silentFrom);
        rig.Run(3);
        silentFrom = rig.Now.TotalSeconds;
        rig.Run(2);
        CheckRestored(rig);
        Assert.Equal(MissionPhase.Revisiting, rig.Status.Phase);
    }

    // A walker at 3 m/s: what is commanded is within a few degrees of where it is, seen from the vehicle.
    private static void CheckDirection(MissionRig rig)
    {
        (double n, double e) = rig.Vehicle.Movers[0](rig.Now)!.Value;
        (double forward, double right) = Turned(n - rig.Vehicle.North, e - rig.Vehicle.East, -rig.Vehicle.Yaw);
        VehicleCommand last = Pointed(rig).Last();
        double reach = 40 * Math.Tan((Math.PI / 2) + last.CameraPitch.Radians);
        (double x, double y) = (reach * Math.Cos(last.CameraYaw.Radians), reach * Math.Sin(last.CameraYaw.Radians));
        Assert.InRange(Math.Sqrt(((forward - x) * (forward - x)) + ((right - y) * (right - y))), 0, 5);
    }

    private static void CheckRestored(MissionRig rig)
    {
        rig.Run(2);
        VehicleCommand last = Pointed(rig).Last();
        Assert.Equal((MissionPitch, 0), (Math.Round(last.CameraPitch.Degrees, 6), last.CameraYaw.Degrees));
        int before = rig.Vehicle.Count(VehicleCommandKind.PointCamera);
        rig.Run(5);
        Assert.Equal(before, rig.Vehicle.Count(VehicleCommandKind.PointCamera));
    }

    private static IEnumerable<VehicleCommand> Pointed(MissionRig rig) => rig.Vehicle.Commands
        .Select(c => c.Command).Where(c => c.Kind == VehicleCommandKind.PointCamera);

    private static (double Forward, double Right) Turned(double north, double east, double by)
        => ((north * Math.Cos(by)) - (east * Math.Sin(by)), (north * Math.Sin(by)) + (east * Math.Cos(by)));

    // A walker that crosses the field, followed from when it is confirmed.
    private static MissionRig Follow(bool gimbal, Func<TimeSpan, bool>? reports = null)
    {
        MissionRig rig = Open(gimbal, reports);
        rig.Vehicle.Movers.Add(t => (100 + (30 * Math.Sin(t.TotalSeconds / 10)), 30 * Math.Cos(t.TotalSeconds / 10)));
        Assert.Equal(MissionPhase.Revisiting, rig.RunUntil(MissionPhase.Revisiting));
        return rig;
    }

    private static MissionRig Open(bool gimbal, Func<TimeSpan, bool>? reports = null)
    {
        var rig = new MissionRig(
            MissionRig.Mission(string.Format(
                CultureInfo.InvariantCulture,
                ", \"camera\": {{\"gimbal\": {0}, \"pitchDegrees\": {1}}}, "
                + "\"targetMotions\": {{\"red\": \"walking\"}}, "
                + "\"revisit\": {{\"maxWayFraction\": 2, \"followSeconds\": 15}}",
                gimbal ? "true" : "false", MissionPitch)),
            options => options.GimbalFrame = GimbalFrame.Heading);
        TimeSpan? reported = null;
        rig.Vehicle.More = (ref VehicleState state) =>
        {
            state.Attitude = EulerAngles.FromRadians(0, 0, rig.Vehicle.Yaw);
            if (gimbal && reports?.Invoke(rig.Now) != false)
                reported = rig.Now;
            state.GimbalTime = reported;
        };
        return rig;
    }
}
