using System;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>The autopilot's clock on ours.</summary>
public class ClockTests(ITestOutputHelper output)
{
    private const double Offset = 37.123;

    [Theory]
    [InlineData(0, 0, 0.05, 0.05)]
    [InlineData(20e-6, 2, 0.3, 1)]
    [InlineData(-20e-6, 2, 0.3, 1)]
    [InlineData(20e-6, 5, 0.5, 2)]
    [InlineData(-50e-6, 5, 0.5, 2)]
    [InlineData(20e-6, 15, 1.5, 6)]
    public void Timesync_DriftAndJitter_AreFollowed(double drift, double jitterMs, double rmsMs, double worstMs)
    {
        double worst = 0;
        double squares = 0;
        int count = 0;
        for (int seed = 1; seed <= 20; seed++)
        {
            var link = new JitteryLink(seed, drift, jitterMs);
            for (int second = 0; second < 600; second++)
            {
                link.RunOneSecond();
                if (second < 20)
                    continue;
                double errorMs = link.ErrorSeconds() * 1000;
                worst = Math.Max(worst, Math.Abs(errorMs));
                squares += errorMs * errorMs;
                count++;
            }
        }

        double rms = Math.Sqrt(squares / count);
        output.WriteLine(
            $"seeds 1 to 20, drift {drift}, jitter {jitterMs} ms: rms {rms:0.000} ms, worst {worst:0.000} ms");
        Assert.True(rms <= rmsMs && worst <= worstMs, $"rms {rms} ms, worst {worst} ms");
    }

    [Fact]
    public void Timesync_QueuesOneWay_BendTheLineLittle()
    {
        var link = new JitteryLink(seed: 3, drift: 20e-6, jitterMs: 2)
        {
            SlowWayBack = n => n % 5 == 0 ? 0.04 : n % 7 == 0 ? 0.4 : 0
        };
        for (int second = 0; second < 300; second++)
            link.RunOneSecond();
        output.WriteLine($"error {link.ErrorSeconds() * 1000:0.000} ms, rejected {link.Clock.Timesync.Rejected}");
        Assert.True(Math.Abs(link.ErrorSeconds()) < 1e-3);
        Assert.True(link.Clock.Timesync.Rejected > 20);
    }

    [Theory]
    [InlineData(0.1)]
    [InlineData(-30)]
    [InlineData(1000)]
    public void Timesync_ClockJumps_IsRestarted(double jump)
    {
        var link = new JitteryLink(seed: 4, drift: 20e-6, jitterMs: 5);
        for (int second = 0; second < 60; second++)
            link.RunOneSecond();
        link.Jump = jump;
        for (int second = 0; second < 10; second++)
            link.RunOneSecond();
        Assert.Equal(1, link.Clock.Timesync.Jumps);
        Assert.Equal(ClockBasis.Timesync, link.Clock.BasisAt(link.Now));
        Assert.True(Math.Abs(link.ErrorSeconds()) < 2e-3);
    }

    [Fact]
    public void Timesync_AnswersToOthersAndRequests_AreNotTaken()
    {
        var clock = new AutopilotClock();
        clock.Requests.Start(TimeSpan.Zero);
        Assert.True(clock.Requests.TryNext(TimeSpan.Zero, out Timesync request));
        for (int i = 0; i < 10; i++)
        {
            clock.Take(new Timesync { Ts1 = 12345, Tc1 = 5_000_000_000 }, TimeSpan.FromMilliseconds(20));
            clock.Take(new Timesync { Ts1 = request.Ts1 }, TimeSpan.FromMilliseconds(20));
        }

        Assert.True(double.IsNaN(clock.Timesync.ShortestRoundTripSeconds));
        clock.Take(new Timesync { Ts1 = request.Ts1, Tc1 = 5_000_000_000 }, TimeSpan.FromMilliseconds(20));
        // the same once more
        clock.Take(new Timesync { Ts1 = request.Ts1, Tc1 = 9_000_000_000 }, TimeSpan.FromMilliseconds(30));
        Assert.Equal(0.02, clock.Timesync.ShortestRoundTripSeconds, 6);
        Assert.Equal(0, clock.Timesync.Jumps);
    }

    [Fact]
    public void Timesync_NoAnswersAnyMore_FallsBackAfterAMinute()
    {
        var link = new JitteryLink(seed: 5, drift: 0, jitterMs: 1);
        for (int second = 0; second < 10; second++)
            link.RunOneSecond();
        link.Clock.Map(47_000, link.Now);
        Assert.Equal(ClockBasis.Timesync, link.Clock.BasisAt(link.Now + TimeSpan.FromSeconds(59)));
        Assert.Equal(ClockBasis.Arrival, link.Clock.BasisAt(link.Now + TimeSpan.FromSeconds(61)));
    }

    [Fact]
    public void Arrival_WithoutTimesync_IsTheQuickestMessageAndNeverLaterThanItCame()
    {
        var clock = new AutopilotClock();
        var random = new Random(6);
        for (int i = 0; i < 1000; i++)
        {
            uint boot = (uint)(60_000 + (i * 40));
            TimeSpan arrival = TimeSpan.FromMilliseconds(boot - 50_000 + 20 + (random.NextDouble() * 30));
            TimeSpan mapped = clock.Map(boot, arrival);
            Assert.True(mapped <= arrival);
            if (i > 100)
                Assert.InRange((mapped - TimeSpan.FromMilliseconds(boot - 50_000)).TotalMilliseconds, 19.9, 22);
        }

        Assert.Equal(ClockBasis.Arrival, clock.BasisAt(TimeSpan.FromSeconds(60)));
    }

    [Fact]
    public void Arrival_WrapOf32Bits_GoesOn()
    {
        var clock = new AutopilotClock();
        for (int i = -100; i < 100; i++)
        {
            uint boot = unchecked((uint)(i * 100));
            TimeSpan arrival = TimeSpan.FromSeconds(100 + (i * 0.1));
            Assert.Equal(arrival, clock.Map(boot, arrival));
        }
    }

    [Fact]
    public void Requests_AreFastForTwoSecondsThenOnceASecond()
    {
        var requester = new MavlinkTimesyncRequester();
        requester.Start(TimeSpan.FromSeconds(1));
        double[] asked = Enumerable.Range(0, 1200).Select(i => 1 + (i * 0.01))
            .Where(t => requester.TryNext(TimeSpan.FromSeconds(t), out _)).ToArray();
        Assert.Equal(10, asked.Count(t => t < 2.995));
        Assert.Equal(10, asked.Count(t => t > 2.995));
    }

    [Fact]
    public void Manager_AsksTheAutopilotAndMapsItsPoses()
    {
        using var copter = new ScriptedAutopilot(options: new AutopilotOptions { RequestedRates = [] });
        AnswerTimesync(copter, seconds: 5);
        Timesync request = copter.Rig.Sink.MessagesOf<Timesync>()[0];
        Assert.Equal((0L, 1, 1), (request.Tc1, request.TargetSystem, request.TargetComponent));
        Assert.InRange(copter.Rig.Sink.MessagesOf<Timesync>().Count, 12, 14);

        // It says of its positions when they were true; they come 20 ms later.
        PoseSample pose = copter.Rig.Peers.Poses.Last();
        Assert.Equal(PoseSampleKind.Position, pose.Kind);
        Assert.Equal((30.0, 0.7), (pose.HeightAboveHomeMetres, Math.Round(pose.Position.Latitude.Radians, 3)));
        double sentAt = copter.Rig.Vehicle.PositionTime!.Value.TotalSeconds - copter.Latency;
        Assert.InRange(pose.Time.TotalSeconds - sentAt, -0.002, 0.002);
    }

    // Which of the two ways takes longer cannot be seen: the times are off by up to half of the round trip.
    [Fact]
    public void Manager_TimeOfPoses_IsAsUncertainAsHalfTheRoundTrip()
    {
        using var copter = new ScriptedAutopilot(options: new AutopilotOptions { RequestedRates = [] });
        AnswerTimesync(copter, seconds: 5);
        double half = copter.Latency;
        Assert.InRange(
            copter.Rig.Peers.Poses.Last().TimeErrorSeconds, half / Math.Sqrt(3), (half / Math.Sqrt(3)) + 0.002);
    }

    [Fact]
    public void Manager_EveryPositionAndAttitude_IsAPose()
    {
        using var rig = new AutopilotRig();
        rig.Beat(1);
        for (int i = 0; i < 20; i++)
        {
            rig.Send(new Attitude { TimeBootMs = (uint)(1000 + (i * 10)), Roll = 0.1f, Yawspeed = 0.2f });
            rig.Send(new GlobalPositionInt { TimeBootMs = (uint)(1000 + (i * 10)), Lat = 1, Lon = 1 });
        }

        rig.Send(new GlobalPositionInt { TimeBootMs = 2000 });               // no place
        rig.Send(new Attitude { Roll = float.NaN });                         // no attitude
        rig.Send(new Attitude { Roll = 0.1f }, component: 99);               // not the autopilot's
        rig.Run();
        Assert.Equal(20, rig.Peers.Poses.Count(p => p.Kind == PoseSampleKind.Position));
        Assert.Equal(20, rig.Peers.Poses.Count(p => p.Kind == PoseSampleKind.Attitude));
        PoseSample attitude = rig.Peers.Poses[0];
        Assert.Equal(
            (0.1, 0.2),
            (Math.Round(attitude.Attitude.Roll.Radians, 6), Math.Round(attitude.Rates.YawRadiansPerSecond, 6)));
    }

    [Fact]
    public void Manager_OnAReplay_SendsNoRequest()
    {
        using var copter = new ScriptedAutopilot(mayCommand: false);
        copter.Run(10);
        Assert.Empty(copter.Rig.Sink.Frames);
        Assert.NotEmpty(copter.Rig.Peers.Poses);
    }

    // The clock of the scripted autopilot is 60 s ahead.
    private static void AnswerTimesync(ScriptedAutopilot copter, double seconds)
    {
        int answered = 0;
        for (int i = 0; i < seconds * 100; i++)
        {
            copter.Run(0.01);
            foreach (Timesync request in copter.Rig.Sink.MessagesOf<Timesync>().Skip(answered))
            {
                long theirs = (long)((60 + copter.Rig.Reactor.Now.TotalSeconds + copter.Latency) * 1e9);
                copter.Say(new Timesync { Ts1 = request.Ts1, Tc1 = theirs }, later: copter.Latency);
                answered++;
            }
        }
    }

    /// <summary>A link of 20 ms each way and jitter, and a clock that is ahead and drifts.</summary>
    private sealed class JitteryLink(int seed, double drift, double jitterMs)
    {
        private readonly Random _random = new(seed);
        private double _now;
        private int _answers;

        public AutopilotClock Clock { get; } = new();

        public double Jump { get; set; }

        public Func<int, double> SlowWayBack { get; set; } = _ => 0;

        public TimeSpan Now => TimeSpan.FromSeconds(_now);

        public void RunOneSecond()
        {
            if (!Clock.Requests.IsStarted)
                Clock.Requests.Start(Now);
            for (int i = 0; i < 20; i++)
            {
                _now += 0.05;
                if (!Clock.Requests.TryNext(Now, out Timesync request))
                    continue;
                double received = _now + Delay();
                double back = received + Delay() + SlowWayBack(_answers++);
                Clock.Take(
                    new Timesync { Ts1 = request.Ts1, Tc1 = (long)(Theirs(received) * 1e9) },
                    TimeSpan.FromSeconds(back));
            }
        }

        /// <summary>How wrong something is mapped that is true now and comes in 20 ms later.</summary>
        public double ErrorSeconds()
        {
            double truth = Math.Round(Theirs(_now), 3);
            TimeSpan mapped = Clock.Map((uint)Math.Round(truth * 1000), TimeSpan.FromSeconds(_now + 0.04));
            return mapped.TotalSeconds - (_now + truth - Theirs(_now));
        }

        private double Theirs(double ours) => ours + Offset + Jump + (drift * ours);

        private double Delay() => 0.02 + (jitterMs / 1000 * ((2 * _random.NextDouble()) - 1));
    }
}
