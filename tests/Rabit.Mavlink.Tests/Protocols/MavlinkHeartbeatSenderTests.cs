using System;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

public class MavlinkHeartbeatSenderTests
{
    private readonly MavlinkHeartbeatSender _heartbeats = new(
        ScriptedVehicle.Companion(), new Heartbeat { CustomMode = 1 });

    [Fact]
    public void TryTakeFrame_LateCalls_KeepsTheGridAndMakesNothingUp()
    {
        Assert.Equal((1, 1), (Sent(10), Sent(11)));
        Assert.Equal((0, 1), (Sent(11.9), Sent(12.3)));   // late by 0.3 s
        Assert.Equal(TimeSpan.FromSeconds(13), _heartbeats.NextDue);
        Assert.Equal((1, 1), (Sent(13), Sent(17.5)));     // three are missed
        Assert.Equal(TimeSpan.FromSeconds(18.5), _heartbeats.NextDue);
    }

    [Fact]
    public void TryTakeFrame_HeartbeatSetBetween_SendsTheNewOne()
    {
        Assert.True(
            _heartbeats.TryTakeFrame(TimeSpan.Zero, out MavlinkFrame frame) && frame.TryDecode(out Heartbeat first)
                && first.CustomMode == 1);
        _heartbeats.Heartbeat = new Heartbeat { CustomMode = 2 };
        Assert.False(_heartbeats.TryTakeFrame(TimeSpan.Zero, out _));
        Assert.True(
            _heartbeats.TryTakeFrame(TimeSpan.FromSeconds(1), out frame) && frame.TryDecode(out Heartbeat second)
                && second.CustomMode == 2);
    }

    [Fact]
    public void Enabled_False_SendsNothing()
    {
        _heartbeats.Enabled = false;
        Assert.Equal(TimeSpan.MaxValue, _heartbeats.NextDue);
        Assert.Equal(0, Sent(5));
        _heartbeats.Enabled = true;
        Assert.Equal(1, Sent(6));
    }

    [Fact]
    public void Constructor_BadArguments_Throws()
    {
        Assert.Throws<ArgumentNullException>("sender", () => new MavlinkHeartbeatSender(null!, default));
        Assert.Throws<ArgumentOutOfRangeException>(
            "period", () => new MavlinkHeartbeatSender(ScriptedVehicle.Companion(), default, TimeSpan.Zero));
    }

    private int Sent(double seconds)
    {
        int sent = 0;
        while (_heartbeats.TryTakeFrame(TimeSpan.FromSeconds(seconds), out _))
            sent++;
        return sent;
    }
}
