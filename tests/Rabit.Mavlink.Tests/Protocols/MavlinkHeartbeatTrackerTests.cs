using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>Components that are connected, lost, and rebooted.</summary>
public class MavlinkHeartbeatTrackerTests
{
    private readonly MavlinkHeartbeatTracker _tracker = new(capacity: 2);
    private readonly MavlinkSender _vehicle = new(1, 1);
    private readonly List<MavlinkComponentEvent> _events = [];

    [Fact]
    public void Silence_IsALossAfterFiveSecondsAndAReturnLater()
    {
        Receive(0, new Heartbeat());
        Receive(1, new Heartbeat());
        Assert.Equal(TimeSpan.FromSeconds(6), _tracker.NextDue);
        Poll(5.9);
        Assert.Equal([MavlinkComponentEvent.Appeared], _events);
        Poll(6);
        Poll(100);
        Receive(101, new Heartbeat { CustomMode = 4 });
        Assert.Equal(
            [MavlinkComponentEvent.Appeared, MavlinkComponentEvent.Lost, MavlinkComponentEvent.Returned], _events);
        Assert.Equal((4u, 3L, false), (_tracker[0].Heartbeat.CustomMode, _tracker[0].Heartbeats, _tracker[0].IsLost));
    }

    [Fact]
    public void LossBetweenTwoCalls_IsStillReported()
    {
        Receive(0, new Heartbeat());
        Receive(20, new Heartbeat());
        Assert.Equal(
            [MavlinkComponentEvent.Appeared, MavlinkComponentEvent.Lost, MavlinkComponentEvent.Returned], _events);
    }

    [Fact]
    public void BootTime_GoesDown_IsAReboot_OvertakingAndTurningRoundAreNot()
    {
        Receive(0, new Heartbeat());
        Receive(1, new SystemTime { TimeBootMs = uint.MaxValue - 500 });
        Receive(2, new SystemTime { TimeBootMs = 500 });   // 49.7 days are over
        Receive(4, new Heartbeat());
        Receive(8, new Heartbeat());
        Receive(10, new Attitude { TimeBootMs = 8500 });
        Receive(10.1, new GlobalPositionInt { TimeBootMs = 7000 });   // overtaken
        Receive(11, new Heartbeat());
        Receive(11, new SystemTime { TimeUnixUsec = 77, TimeBootMs = 9500 });
        Assert.Equal([MavlinkComponentEvent.Appeared], _events);
        Receive(14, new LocalPositionNed { TimeBootMs = 1200 });
        Receive(15, new AttitudeQuaternion { TimeBootMs = 2200 });
        Assert.Equal([MavlinkComponentEvent.Appeared, MavlinkComponentEvent.Rebooted], _events);
        Assert.Equal(1, _tracker[0].Reboots);
    }

    [Theory]
    [InlineData(0, new uint[] { 1000, 2000, 3000 })]
    [InlineData(1, new uint[] { 100_000, 200, 240 })]
    [InlineData(1, new uint[] { 100_000, 200, 1200, 2200 })]
    [InlineData(2, new uint[] { 100_000, 200, 240, 50_000, 50_040, 100, 140 })]
    [InlineData(0, new uint[] { 100_000, 200, 100_040, 200, 200, 100_080 })]   // one wrong, or repeated by the network
    [InlineData(0, new uint[] { 100_000, 3_700_000, 100_040, 100_080, 100_120 })]   // one of the future
    [InlineData(0, new uint[] { 100_000, 3_700_000, 3_700_040 })]           // a pause
    [InlineData(0, new uint[] { 10_000, 7_500, 10_200, 7_600 })]           // messages that overtook each other
    [InlineData(0, new uint[] { uint.MaxValue - 500, 400, 1400 })]          // 49.7 days
    [InlineData(0, new uint[] { uint.MaxValue - 500, 400, uint.MaxValue - 100, 1400 })]
    [InlineData(1, new uint[] { 3_000_000_000, 5_000, 5_040 })]
    [InlineData(0, new uint[] { 0, 0, 0 })]
    public void BootTimes_InTurn_CountTheBoots(int boots, uint[] times)
    {
        Receive(0, new Heartbeat());
        foreach (uint time in times)
            Receive(1, new SystemTime { TimeBootMs = time });
        Assert.Equal(boots, _tracker[0].Reboots);
        Assert.Equal(boots, _events.FindAll(e => e == MavlinkComponentEvent.Rebooted).Count);
    }

    // Messages with a boot time may be seconds apart; the clock of TIMESYNC is asked for once a second.
    [Fact]
    public void Timesync_ItsClockStartsAgain_IsOneRebootWithTheBootTimesThatFollow()
    {
        Receive(0, new Heartbeat());
        Receive(1, new SystemTime { TimeBootMs = 60_000 });
        Receive(1, new Timesync { Ts1 = 1, Tc1 = 60_000_000_000 });
        Receive(2, new Timesync { Ts1 = 2, Tc1 = 61_000_000_000 });
        Receive(2.1, new Timesync { Ts1 = 5 });   // a question says nothing
        Receive(2.2, new Timesync { Ts1 = 1, Tc1 = 60_500_000_000 });   // overtaken
        Assert.Equal(0, _tracker[0].Reboots);
        Receive(3, new Timesync { Ts1 = 3, Tc1 = 3_600_000_000_000 });   // a wrong answer
        Receive(3.1, new Timesync { Ts1 = 4, Tc1 = 62_100_000_000 });
        Receive(3.2, new Timesync { Ts1 = 5, Tc1 = 62_200_000_000 });
        Assert.Equal(0, _tracker[0].Reboots);
        Receive(4, new Timesync { Ts1 = 6, Tc1 = 900_000_000 });
        Assert.Equal(0, _tracker[0].Reboots);
        Receive(4.5, new SystemTime { TimeBootMs = 1_400 });
        Receive(5, new Timesync { Ts1 = 7, Tc1 = 1_900_000_000 });
        Assert.Equal(1, _tracker[0].Reboots);
        Receive(5.5, new SystemTime { TimeBootMs = 2_400 });
        Assert.Equal(1, _tracker[0].Reboots);
    }

    [Fact]
    public void MoreComponentsThanRoom_AreCounted()
    {
        for (byte component = 1; component <= 4; component++)
            _tracker.Handle(MavlinkFrame.Create(default(Heartbeat), 1, component, 0), TimeSpan.Zero);
        Assert.Equal((2, 2L), (_tracker.Count, _tracker.Overflow));
    }

    private void Receive<T>(double seconds, T message)
        where T : struct, IMavlinkMessage
    {
        _tracker.Handle(_vehicle.Create(message), TimeSpan.FromSeconds(seconds));
        Poll(seconds);
    }

    private void Poll(double seconds)
    {
        while (_tracker.TryTakeEvent(TimeSpan.FromSeconds(seconds), out MavlinkComponentEvent happened, out _))
            _events.Add(happened);
    }
}
