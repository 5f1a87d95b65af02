using System;
using System.IO;
using System.Text.Json;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>The recorded flights, through the manager in virtual time, against the facts listed beside them.</summary>
public class FlightReplayTests
{
    [Theory]
    [InlineData("ardupilot-flight", MavAutopilot.Ardupilotmega)]
    [InlineData("px4-flight", MavAutopilot.Px4)]
    public void Statistics_RecordedFlight_CountEveryFrameAndNoFault(string name, MavAutopilot autopilot)
    {
        AutopilotStatistics statistics = Replay(name, out VehicleState end, out int sent);
        using JsonDocument sidecar = TestData.Json(name + ".json");

        Assert.Equal(
            sidecar.RootElement.GetProperty("sequence")[0].GetProperty("frames").GetInt64(), statistics.Frames);
        Assert.Equal(
            (0L, 0L, 0L, 0L),
            (statistics.RefusedMessages, statistics.Losses, statistics.Reboots,
                statistics.HeartbeatsOfOtherAutopilots));
        Assert.Equal((autopilot, MavType.Quadrotor), (end.Autopilot, end.VehicleType));
        Assert.Equal(((byte)1, (byte)1), (end.SystemId, end.ComponentId));
        Assert.True(end.IsConnected);
        Assert.False(end.IsArmed);
        Assert.Equal(0, sent);
    }

    [Fact]
    public void VehicleState_AtTheEndOfAFlight_HoldsTheLastOfEverything()
    {
        Replay("ardupilot-flight", out VehicleState end, out _);

        Assert.Equal("RTL", end.Mode);
        Assert.Equal(MavLandedState.OnGround, end.LandedState);
        Assert.InRange(end.Position.Latitude.Degrees, -35.3634, -35.3626);
        Assert.InRange(end.Position.Longitude.Degrees, 149.165, 149.1661);
        Assert.InRange(end.HeightAboveHomeMetres, -0.1, 0.2);
        Assert.InRange(end.Attitude.Roll.Radians, -0.1, 0.1);
        Assert.InRange(end.BatteryVolts, 10, 17);
        Assert.InRange(end.BatteryRemaining, 0.01, 1);
        Assert.True(end.GpsFix >= GpsFixType.Type3dFix);
        Assert.InRange(end.Satellites, 4, 60);
        Assert.True(end.GpsUtcMicroseconds > 1_500_000_000_000_000);
        Assert.NotNull(end.PositionTime);
        Assert.NotNull(end.AttitudeTime);
        Assert.True(end.LastHeartbeatTime > TimeSpan.FromSeconds(160));
    }

    private static AutopilotStatistics Replay(string name, out VehicleState end, out int sent)
    {
        using FileStream file = File.OpenRead(TestData.PathOf(name + ".tlog"));
        var log = new TlogReader(file, MavlinkDialect.All);
        using var rig = new AutopilotRig();
        long? first = null;
        while (log.TryRead(out MavlinkFrame frame, out TlogRecord record))
        {
            first ??= record.TimeMicroseconds;
            TimeSpan time = TimeSpan.FromTicks((record.TimeMicroseconds - first.Value) * 10);
            rig.Reactor.RunFor(time - rig.Reactor.Now);

            // What the recorder itself sent is counted by Communications and never routed.
            if (frame.ComponentId != 191)
                rig.Push(
                    new LinkFrame
                    {
                        Frame = frame,
                        Index = record.Index,
                        Time = time,
                        UtcMicroseconds = record.TimeMicroseconds
                    });
        }

        rig.Run();
        end = rig.Vehicle;
        sent = rig.Sink.Frames.Count;
        return rig.Statistics;
    }
}
