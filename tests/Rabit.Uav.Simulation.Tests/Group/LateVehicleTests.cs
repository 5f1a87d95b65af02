using System;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation.Tests.Missions;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Group;

/// <summary>
/// A vehicle of a group is switched on after another one has seen eight walkers, of which no vehicle sees any then. The
/// test is in the place of that one's camera for as long as it sees them.
/// </summary>
public sealed class LateVehicleTests(ITestOutputHelper output)
{
    private const int Late = 2;
    private const int Walkers = 8;
    private const double MetresPerSecond = 1;

    // Far from the area, so that no camera shows where they are not.
    private const double NorthMetres = 400;

    // No vehicle flies to them.
    private const string Declared =
        """
        "targetMotions": { "red": "walking" }, "revisit": { "enabled": false }, "targets"
        """;

    private static readonly TimeSpan SwitchedOn = TimeSpan.FromSeconds(22);
    private static readonly TimeSpan Exchanges = TimeSpan.FromSeconds(20);
    private static readonly GeodeticPosition Home = GeodeticPosition.FromDegrees(47.3971, 8.5445, 488);
    private static readonly TargetClassName Red = new("red");

    [Theory]
    [InlineData(0)]
    [InlineData(2400)]
    public void Flight_OneIsSwitchedOnLate_KnowsTheTargetsThatMoveAndTheRadioIsAtRest(int budget)
    {
        QueueSender<CameraObservation>? camera = null;
        using GroupFlight flight = Open(
            (number, reactor) =>
            {
                if (number == 0)
                    camera = reactor.Workspace.Send<CameraObservation>(MessageNames.CameraObservations);
            },
            budget == 0 ? null : new SendBudget { BytesPerSecond = budget });
        for (int i = 0; i < 10; i++)
        {
            RunTo(flight, TimeSpan.FromSeconds(12 + (0.5 * i)));
            camera!.Push(Picture(i, flight.Group.Now));
        }

        RunTo(flight, SwitchedOn);
        Assert.Equal(Walkers, Moving(flight, 0).Length);

        // Two exchanges of states.
        long before = flight.Group.RadioOf(0).BytesSent;
        RunTo(flight, SwitchedOn + Exchanges);
        double rate = 8 * (flight.Group.RadioOf(0).BytesSent - before) / Exchanges.TotalSeconds;
        TargetTrack[] known = Moving(flight, Late);
        output.WriteLine(FormattableString.Invariant(
            $"{rate:0} bit/s, {known.Length} known, off by up to {known.Max(ErrorOf):0.00} m, last seen ")
            + FormattableString.Invariant($"at {known.Min(t => t.Time.TotalSeconds):0.00} s of the late one's clock"));

        Assert.InRange(rate, 800, 2000);
        Assert.Equal(Walkers, known.Length);
        Assert.All(known, t =>
        {
            Assert.Equal((0, TrackState.Tentative), (t.Reports, t.State));
            Assert.True(t.Time < TimeSpan.Zero, "seen before it was switched on");
            Assert.InRange(t.VelocityNed.North, MetresPerSecond - 0.3, MetresPerSecond + 0.3);
            Assert.InRange(ErrorOf(t), 0, 1);
        });
    }

    private static void RunTo(GroupFlight flight, TimeSpan time)
        => flight.RunUntil(() => flight.Group.Now >= time, 60);

    private static TargetTrack[] Moving(GroupFlight flight, int vehicle)
        => [.. flight.Tracks(vehicle).Tracks.Where(t => t.Motion == TargetMotion.Walking)];

    // They go north, 20 m apart.
    private static double ErrorOf(TargetTrack track)
    {
        NedPosition place = LocalNedFrame.IgnoringGeoid(Home).ToNed(track.Position);
        double north = place.North - NorthAt(SwitchedOn + track.Time);
        double east = place.East - (20 * Math.Round(place.East / 20));
        return Math.Sqrt((north * north) + (east * east));
    }

    private static double NorthAt(TimeSpan time) => NorthMetres + (MetresPerSecond * time.TotalSeconds);

    private static CameraObservation Picture(int number, TimeSpan now)
    {
        double north = NorthAt(now);
        return new CameraObservation
        {
            SourceSystemId = 1,
            Number = 1_000_000 + number,
            Time = now,
            Reports = [.. Enumerable.Range(0, Walkers).Select(k => new TargetReport
            {
                SourceSystemId = 1,
                PictureNumber = 1_000_000 + number,
                Index = k,
                Time = now,
                Position = PlaceAt(north, 20 * k),
                Covariance = new HorizontalCovariance(0.25, 0, 0.25),
                Class = Red,
                Score = 0.9,
                SizeMetres = 1,
            })],
            TopLeft = PlaceAt(north + 50, -50),
            TopRight = PlaceAt(north + 50, 200),
            BottomRight = PlaceAt(north - 50, 200),
            BottomLeft = PlaceAt(north - 50, -50),
        };
    }

    private static GeodeticPosition PlaceAt(double north, double east)
        => LocalNedFrame.IgnoringGeoid(Home).ToGeodetic(new NedPosition(north, east, 0));

    private static GroupFlight Open(Action<int, RabitReactor> wire, SendBudget? radioBudget)
    {
        SimulationOptions world = SearchFlight.SmallWorld();
        world.TargetCount = 0;
        world.DistractorCount = 0;
        MissionPlan plan = MissionPlan.Parse(
            SearchFlight.SmallMission.Replace("\"targets\"", Declared), "late");
        var options = new SimulatedGroupOptions
        {
            Vehicles = 3,
            World = world,
            Faults = [new SimulatedGroupFault(Late, SimulatedGroupFaultKind.SwitchedOn, SwitchedOn)],
        };
        return new GroupFlight(plan, options, layerSpacingMetres: 19, wire: wire, radioBudget: radioBudget);
    }
}
