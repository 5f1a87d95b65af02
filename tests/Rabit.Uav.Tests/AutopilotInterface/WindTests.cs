using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>The autopilot's estimate of the wind, as both makes report it.</summary>
public class WindTests
{
    [Theory]
    [InlineData(70, 8.0, -2.736, -7.518)]
    [InlineData(-180, 5, 5, 0)]
    [InlineData(270, 3, 0, 3)]
    public void Update_Wind_BlowsAwayFromItsDirection(float fromDegrees, float speed, double north, double east)
    {
        VehicleTracker tracker = ConnectedTracker();

        VehicleEvents events = Update(tracker, new Wind { Direction = fromDegrees, Speed = speed }, 3);

        Assert.Equal(VehicleEvents.Changed, events & (VehicleEvents.Changed | VehicleEvents.Refused));
        Assert.Equal(north, tracker.State.WindVelocityNed.North, 3);
        Assert.Equal(east, tracker.State.WindVelocityNed.East, 3);
        Assert.Equal(speed, tracker.State.WindMetresPerSecond, 5);
        Assert.Equal(TimeSpan.FromSeconds(3), tracker.State.WindTime);
    }

    [Fact]
    public void Update_WindCov_IsTheVelocityOfTheAir()
    {
        VehicleTracker tracker = ConnectedTracker();

        Update(tracker, new WindCov { WindX = -3, WindY = 4, WindZ = 2 }, 3);

        Assert.Equal((-3.0, 4.0, 0.0),
            (tracker.State.WindVelocityNed.North, tracker.State.WindVelocityNed.East,
                tracker.State.WindVelocityNed.Down));
        Assert.Equal(5, tracker.State.WindMetresPerSecond, 5);
        Assert.Equal(TimeSpan.FromSeconds(3), tracker.State.WindTime);
    }

    [Fact]
    public void Update_WindThatIsNone_IsRefused()
    {
        VehicleTracker tracker = ConnectedTracker();
        foreach (Wind wind in (Wind[])[
            new Wind { Direction = float.NaN, Speed = 3 }, new Wind { Direction = 361, Speed = 3 },
            new Wind { Direction = 1, Speed = -1 }, new Wind { Direction = 1, Speed = 114 },
            new Wind { Direction = 1, Speed = float.NaN }])
            Assert.True((Update(tracker, wind, 1) & VehicleEvents.Refused) != 0);
        foreach (WindCov wind in (WindCov[])[
            new WindCov { WindX = float.NaN, WindY = 1 }, new WindCov { WindX = 1, WindY = float.PositiveInfinity },
            new WindCov { WindX = 100, WindY = 100 }])
            Assert.True((Update(tracker, wind, 1) & VehicleEvents.Refused) != 0);

        Assert.Null(tracker.State.WindTime);
        Assert.True(double.IsNaN(tracker.State.WindMetresPerSecond));
    }

    // As recorded: ArduCopter sends 0 m/s from -180 degrees on the ground and for whole flights without an estimate.
    [Fact]
    public void Update_ExactlyNoWind_IsNotAnEstimate()
    {
        VehicleTracker tracker = ConnectedTracker();
        VehicleEvents ofWind = Update(tracker, new Wind { Direction = -180 }, 1);
        VehicleEvents ofWindCov = Update(tracker, default(WindCov), 1);

        Assert.Equal((VehicleEvents.None, VehicleEvents.None), (ofWind, ofWindCov));
        Assert.Null(tracker.State.WindTime);
    }

    [Fact]
    public void Recording_LegsInWind_EstimateIsTheTrueWind()
    {
        using JsonDocument facts = JsonDocument.Parse(File.ReadAllText(TestData.AutopilotPathOf("ap-wind.json")));
        JsonElement truth = facts.RootElement.GetProperty("true_wind");
        (double Seconds, double Speed, double To)[] estimates = Replay(out VehicleTracker tracker);

        Assert.NotNull(tracker.State.WindTime);
        Assert.All(
            estimates.Where(e => e.Seconds > 10),
            e =>
            {
                // The estimator needs drag coefficients, which were set roughly: it is 8 % off, and 4 degrees in turns.
                double trueSpeed = truth.GetProperty("speed_mps").GetDouble();
                Assert.InRange(e.Speed, 0.95 * trueSpeed, 1.1 * trueSpeed);
                Assert.InRange(e.To, truth.GetProperty("from_deg").GetDouble() - 184,
                    truth.GetProperty("from_deg").GetDouble() - 176);
            });

        // On the ground it had none, and its zeros are not taken for one.
        Assert.InRange(estimates.First(e => !double.IsNaN(e.Speed)).Seconds, 4, 9);
    }

    [Theory]
    [InlineData(MavAutopilot.Ardupilotmega, 168)]
    [InlineData(MavAutopilot.Px4, 231)]
    public void Rates_OfTheWind_AreAskedByTheMake(MavAutopilot make, int messageId)
    {
        using var rig = new AutopilotRig(new AutopilotOptions { RequestedRates = [new(168, 1), new(231, 1)] });
        Heartbeat heartbeat = AutopilotRig.Copter();
        heartbeat.Autopilot = make;
        rig.Send(heartbeat);
        rig.Run();
        rig.Send(new CommandAck { Command = MavCmd.SetMessageInterval, Result = MavResult.Accepted });
        rig.Run();

        Assert.Equal(
            [messageId],
            rig.Sink.Frames.Where(f => f.Frame.MessageId == CommandLong.MavlinkId)
                .Select(f => OutgoingSink.Decode<CommandLong>(f.Frame))
                .Where(c => c.Command == MavCmd.SetMessageInterval).Select(c => (int)c.Param1).Distinct());
    }

    // Speed NaN while nothing is known.
    private static (double Seconds, double Speed, double ToDegrees)[] Replay(out VehicleTracker tracker)
    {
        using FileStream file = File.OpenRead(TestData.AutopilotPathOf("ap-wind.wind.tlog"));
        var log = new TlogReader(file, MavlinkDialect.All);
        var estimates = new List<(double, double, double)>();
        tracker = new VehicleTracker(null, TimeSpan.FromSeconds(5));
        long? first = null;
        while (log.TryRead(out MavlinkFrame frame, out TlogRecord record))
        {
            first ??= record.TimeMicroseconds;
            TimeSpan time = TimeSpan.FromTicks((record.TimeMicroseconds - first.Value) * 10);
            VehicleEvents events = tracker.UpdateBy(new LinkFrame { Frame = frame, Time = time });
            Assert.Equal(VehicleEvents.None, events & VehicleEvents.Refused);
            estimates.Add((time.TotalSeconds, tracker.State.WindMetresPerSecond,
                tracker.State.WindVelocityNed.Azimuth.Degrees));
        }

        return [.. estimates];
    }

    private static VehicleTracker ConnectedTracker()
    {
        var tracker = new VehicleTracker(null, TimeSpan.FromSeconds(5));
        tracker.UpdateBy(AutopilotRig.FrameOf(AutopilotRig.Copter(), TimeSpan.Zero));
        return tracker;
    }

    private static VehicleEvents Update<T>(VehicleTracker tracker, T message, double seconds)
        where T : struct, IMavlinkMessage
        => tracker.UpdateBy(AutopilotRig.FrameOf(message, TimeSpan.FromSeconds(seconds)));
}
