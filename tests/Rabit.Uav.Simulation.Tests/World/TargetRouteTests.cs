using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Rabit.Uav.Simulation.Tests.Camera;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.World;

/// <summary>Targets that move: where they are, how fast, and that their tracks are scored.</summary>
public sealed class TargetRouteTests
{
    private static readonly NedPosition[] Area = Scene.Corners((30, -80), (150, -80), (150, 80), (30, 80));
    private static readonly TimeSpan Step = TimeSpan.FromMilliseconds(50);

    [Theory]
    [InlineData(SimulatedMotion.Walking, 1.6, 0.9)]
    [InlineData(SimulatedMotion.Vehicle, 8.01, 2.6)]
    [InlineData(SimulatedMotion.SteadyVehicle, 8.01, 2.6)]
    [InlineData(SimulatedMotion.Erratic, 3.01, 2.1)]
    public void PositionAt_TenMinutes_IsInsideTheAreaWithinItsSpeedAndAcceleration(
        SimulatedMotion motion, double maxSpeed, double maxAcceleration)
    {
        var polygon = new GroundPolygon(Area.Select(c => (c.North, c.East)).ToArray(), nameof(Area));
        for (long seed = 1; seed <= 20; seed++)
        {
            SimulatedTarget target = World(seed, motion).Targets.First();
            (NedPosition last, NedVector lastVelocity) = (target.Position, target.VelocityAt(TimeSpan.Zero));
            double fastest = 0;
            for (TimeSpan time = Step; time < TimeSpan.FromMinutes(10); time += Step)
            {
                NedPosition at = target.PositionAt(time);
                NedVector velocity = target.VelocityAt(time);
                double speed = Length(velocity);
                string text = $"seed {seed} at {time}: {at}, {velocity}";
                Assert.True(polygon.Contains(at.North, at.East), text);
                Assert.True(speed <= maxSpeed, text);
                Assert.True(Length(velocity - lastVelocity) <= maxAcceleration * Step.TotalSeconds, text);

                // The position is the integral of the velocity.
                NedVector mean = 0.5 * (velocity + lastVelocity);
                Assert.True(Length((at - last) - (Step.TotalSeconds * mean)) < 0.01, text);
                (last, lastVelocity) = (at, velocity);
                fastest = Math.Max(fastest, speed);
            }

            Assert.True(fastest > 1, $"seed {seed}: {fastest} m/s");
        }
    }

    [Fact]
    public void VelocityAt_SteadyVehicle_IsEightMetresPerSecondAlways()
    {
        SimulatedTarget target = World(1, SimulatedMotion.SteadyVehicle).Targets.First();
        for (TimeSpan time = TimeSpan.Zero; time < TimeSpan.FromMinutes(2); time += Step)
            Assert.Equal(8, Length(target.VelocityAt(time)), 6);
    }

    [Fact]
    public void PositionAt_SameSeed_IsTheSame()
    {
        TimeSpan time = TimeSpan.FromSeconds(123.456);
        NedPosition first = World(5, SimulatedMotion.Vehicle).Targets.First().PositionAt(time);

        Assert.Equal(first, World(5, SimulatedMotion.Vehicle).Targets.First().PositionAt(time));
        Assert.NotEqual(first, World(6, SimulatedMotion.Vehicle).Targets.First().PositionAt(time));
    }

    [Fact]
    public void Motions_OfTheFirst_LeaveTheOthersWhereTheyAre()
    {
        SimulatedTarget[] standing = World(3).Targets.ToArray();
        SimulatedTarget[] targets = World(3, SimulatedMotion.Walking).Targets.ToArray();

        Assert.Equal(standing[0].Position, targets[0].PositionAt(TimeSpan.Zero));
        TimeSpan later = TimeSpan.FromMinutes(1);
        Assert.Equal(
            standing.Skip(1).Select(t => t.Position), targets.Skip(1).Select(t => t.PositionAt(later)));
    }

    [Fact]
    public void Options_MoreMotionsThanTargets_AreRefusedByName()
        => Assert.Contains(
            nameof(SimulationOptions.Motions),
            Assert.Throws<ArgumentException>(() => new SimulatedWorld(new SimulationOptions
            {
                TargetCount = 0,
                Motions = [SimulatedMotion.Walking],
            })).Message,
            StringComparison.Ordinal);

    [Theory]
    [InlineData(TrackState.Confirmed)]
    [InlineData(TrackState.Lost)]
    public void Score_TrackOfATargetThatMovedOn_IsFoundWhereItWasThen(TrackState state)
    {
        SimulatedWorld world = World(1, SimulatedMotion.Vehicle);
        SimulatedTarget target = world.Targets.First();
        TimeSpan seen = TimeSpan.FromSeconds(100);
        var track = new TargetTrack
        {
            Id = 1,
            State = state,
            Class = target.Class,
            Motion = TargetMotion.Vehicle,
            Position = world.PositionOf(target.PositionAt(seen) + new NedVector(3, 0, 0)),
            Covariance = new HorizontalCovariance(1, 0, 1),
            Time = seen,
            LastSeen = seen,
        };

        MissionScore score = TargetScoring.Score(TargetTruth.Of(world), [track]);

        Assert.Empty(score.FalseTracks);
        Assert.Equal(3, score.Targets[0].ErrorMetres, 2);
    }

    private static SimulatedWorld World(long seed, params SimulatedMotion[] motions)
        => new(new SimulationOptions { Seed = seed, Area = Area, Motions = motions });

    private static double Length(NedVector vector) => Math.Sqrt(NedVector.Dot(vector, vector));
}
