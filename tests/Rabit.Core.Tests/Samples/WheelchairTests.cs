using System;
using System.Collections.Generic;
using Wheelchair;
using Xunit;

namespace Rabit.Core.Tests.Samples;

/// <summary>samples/Wheelchair: how far the chair goes on before it stands, asserted in virtual time.</summary>
public sealed class WheelchairTests
{
    private static readonly TimeSpan Step = Braking.ControlPeriod;
    private static readonly TimeSpan DriverLetsGo = TimeSpan.FromSeconds(7);

    // How much nearer than it must the chair may stand: the bound counts a whole period at full speed, and the decision
    // falls on a period.
    private const double SlackMetres = 0.08;

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void SafetyStop_AtFullSpeedTowardsAWall_StopsWithinTheStoppingDistanceAndLeavesTheClearance(long seed)
    {
        var ride = new Ride(new VirtualTime(seed), _ => { });
        MessageSubscriber<Drive> drive = ride.Reactor.Workspace.Subscribe<Drive>("drive");
        ride.Reactor.Start();

        RunUntil(ride, drive, d => d.SpeedMetresPerSecond >= Braking.TopSpeedMetresPerSecond);
        RunUntil(ride, drive, d => d.IsSafetyStop);
        double decidedAt = ride.Chair.DistanceToWall(ride.Reactor.Now);
        RunUntil(ride, drive, d => d.SpeedMetresPerSecond <= 0);
        double standsAt = ride.Chair.DistanceToWall(ride.Reactor.Now);
        End(ride);

        double bound = Braking.StoppingDistanceMetres(Braking.TopSpeedMetresPerSecond);
        Assert.InRange(decidedAt - standsAt, bound - SlackMetres, bound);
        Assert.InRange(standsAt, Braking.ClearanceMetres, Braking.ClearanceMetres + SlackMetres);
    }

    /// <summary>Whatever the order of its managers, and however long their units of work take.</summary>
    [Fact]
    public void SafetyStop_UnderEveryOrderAndLoad_LeavesTheClearance()
        => Assert.Null(SeedSearch.Find(firstSeed: 1, count: 100, time =>
        {
            time.SetUnitOfWorkDuration("joystick", TimeSpan.Zero, TimeSpan.FromMilliseconds(30));
            time.SetUnitOfWorkDuration("obstacle", TimeSpan.Zero, TimeSpan.FromMilliseconds(30));
            time.SetUnitOfWorkDuration("drive", TimeSpan.Zero, TimeSpan.FromMilliseconds(15));
            var ride = new Ride(time, _ => { });
            ride.Reactor.Start();
            ride.Reactor.RunFor(DriverLetsGo);
            double standsAt = ride.Chair.DistanceToWall(ride.Reactor.Now);
            End(ride);

            Assert.InRange(standsAt, Braking.ClearanceMetres, 2 * Braking.ClearanceMetres);
        }));

    [Fact]
    public void SafetyStop_SensorBreaks_StopsAfterTheOldestInputAndFarFromTheWall()
    {
        var ride = new Ride(new VirtualTime(), _ => { });
        ride.Sensor.BreaksAt = TimeSpan.FromSeconds(3);
        MessageSubscriber<Drive> drive = ride.Reactor.Workspace.Subscribe<Drive>("drive");
        ride.Reactor.Start();
        ride.Reactor.RunFor(TimeSpan.FromSeconds(3));

        RunUntil(ride, drive, d => d.IsSafetyStop);
        Assert.InRange(ride.Reactor.Now.TotalSeconds, 3.15, 3.25);
        RunUntil(ride, drive, d => d.SpeedMetresPerSecond <= 0);

        // From top speed it takes three quarters of a second.
        Assert.InRange(ride.Reactor.Now.TotalSeconds, 3.9, 4.05);
        Assert.True(ride.Chair.DistanceToWall(ride.Reactor.Now) > 2);
        End(ride);
    }

    [Fact]
    public void Ride_ToItsEnd_EndsByItselfAndPrintsTheSameEachTime()
    {
        List<string> lines = Lines(seed: 1);

        Assert.Equal(lines, Lines(seed: 1));
        Assert.Contains(lines, l => l.EndsWith("SAFETY STOP", StringComparison.Ordinal));
    }

    private static List<string> Lines(long seed)
    {
        var lines = new List<string>();
        ReactorResult result = new Ride(new VirtualTime(seed), lines.Add).Reactor.Run();
        Assert.Equal("joystick: the driver got off", result.StopReason);
        Assert.Equal(0, result.ExitCode);
        return lines;
    }

    private static void RunUntil(Ride ride, MessageSubscriber<Drive> drive, Func<Drive, bool> condition)
    {
        do
        {
            Assert.True(ride.Reactor.RunFor(Step) && ride.Reactor.Now < DriverLetsGo, "It never came so.");
            drive.Fetch();
        }
        while (!condition(drive.Value));
    }

    private static void End(Ride ride)
    {
        ride.Reactor.Stop();
        Assert.Equal(0, ride.Reactor.Finish().ExitCode);
    }
}
