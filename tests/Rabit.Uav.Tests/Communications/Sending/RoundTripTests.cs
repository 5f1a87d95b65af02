using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Xunit;

namespace Rabit.Uav.Tests.Communications.Sending;

/// <summary>PING over a link: the measure of a budget that follows the round trip.</summary>
public sealed class RoundTripTests
{
    private readonly Queue<(TimeSpan Due, byte[] Answer)> _answers = new();
    private byte _sequence;

    [Fact]
    public void Rate_WhileFramesWaitSomewhere_FallsAndComesBack()
    {
        using CommunicationsRig rig = Rig(followsRoundTrip: true);
        Run(rig, seconds: 20, roundTripMs: 100);
        Assert.Equal(3600, rig.LastStatus(1).Budget.BytesPerSecond);
        Assert.InRange(rig.LastStatus(1).Budget.RoundTripSeconds, 0.0999, 0.12);

        Run(rig, seconds: 6, roundTripMs: 400);
        Assert.InRange(rig.LastStatus(1).Budget.BytesPerSecond, 3600 * 0.2, 3600 * 0.5);
        Run(rig, seconds: 30, roundTripMs: 400);
        Assert.Equal(3600 * 0.05, rig.LastStatus(1).Budget.BytesPerSecond, 3);

        Run(rig, seconds: 150, roundTripMs: 120);
        Assert.Equal(3600, rig.LastStatus(1).Budget.BytesPerSecond);
    }

    [Fact]
    public void Rate_WayThatBecameLonger_IsUsedInFullAfterAWhile()
    {
        using CommunicationsRig rig = Rig(followsRoundTrip: true);
        Run(rig, seconds: 20, roundTripMs: 100);
        Run(rig, seconds: 450, roundTripMs: 600);
        Assert.Equal(3600, rig.LastStatus(1).Budget.BytesPerSecond);
    }

    [Fact]
    public void Rate_WithoutAnswers_IsThatOfTheBudget()
    {
        using CommunicationsRig rig = Rig(followsRoundTrip: true);
        Run(rig, seconds: 10, roundTripMs: 100);
        Run(rig, seconds: 10, roundTripMs: 600);
        Assert.InRange(rig.LastStatus(1).Budget.BytesPerSecond, 0, 3000);
        Run(rig, seconds: 20, roundTripMs: null);
        Assert.Equal(3600, rig.LastStatus(1).Budget.BytesPerSecond);
    }

    [Fact]
    public void Requests_WithoutTheOption_AreNotSent()
    {
        using CommunicationsRig rig = Rig(followsRoundTrip: false);
        rig.Run(TimeSpan.FromSeconds(5));
        Assert.DoesNotContain(rig.ReceivedFrames(1), f => f.MessageId == Ping.MavlinkId);
        Assert.Equal(0, rig.LastStatus(1).Budget.RoundTripSeconds);
    }

    [Fact]
    public void Answers_OfOthersAndToOthersAndOldOnes_AreNoMeasure()
    {
        using CommunicationsRig rig = Rig(followsRoundTrip: true);
        rig.Run(TimeSpan.FromSeconds(2));
        rig.Send(1, Frames.Of(new Ping { Seq = 1, TargetSystem = 9, TargetComponent = 191 }, 255, 190));
        rig.Send(1, Frames.Of(new Ping { Seq = 77, TargetSystem = 1, TargetComponent = 191 }, 255, 190, 1));
        rig.Send(0, Frames.Of(new Ping { Seq = 1, TargetSystem = 1, TargetComponent = 191 }, 255, 190, 2));
        Assert.Equal(0, rig.Status(1).Budget.RoundTripSeconds);
    }

    private void Run(CommunicationsRig rig, int seconds, double? roundTripMs)
    {
        for (int step = 0; step < seconds * 100; step++)
        {
            rig.Run(TimeSpan.FromMilliseconds(10));
            foreach (MavlinkFrame frame in rig.ReceivedFrames(1).Where(f => f.MessageId == Ping.MavlinkId))
            {
                Assert.True(frame.TryDecode(out Ping ping));
                (ping.TargetSystem, ping.TargetComponent) = (1, 191);
                if (roundTripMs is { } ms)
                    _answers.Enqueue((
                        rig.Reactor.Now + TimeSpan.FromTicks((long)(ms * TimeSpan.TicksPerMillisecond)),
                        Frames.Of(ping, 255, 190, _sequence++)));
            }

            while (_answers.Count > 0 && _answers.Peek().Due <= rig.Reactor.Now)
                rig.Put(1, _answers.Dequeue().Answer);
        }
    }

    private static CommunicationsRig Rig(bool followsRoundTrip) => new CommunicationsRig(
        links: 2,
        o => (o.SendBudgets, o.PositionRateHz) = (
            new Dictionary<int, SendBudget> { [1] = new SendBudget { FollowsRoundTripTime = followsRoundTrip } }, 0),
        new FakeAutopilot(1024) { Keeps = false }).As(1);
}
