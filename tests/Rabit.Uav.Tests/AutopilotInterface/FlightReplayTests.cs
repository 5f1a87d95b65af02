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

/// <summary>The recorded flights, through the manager in virtual time, against the facts listed beside them.</summary>
public class FlightReplayTests
{
    [Theory]
    [InlineData("ardupilot-flight")]
    [InlineData("px4-flight")]
    public void Flight_RecordedFlight_AgreesWithItsSidecar(string name)
    {
        FlightSummary flight = Replay(name, out VehicleState end, out int sent);
        using JsonDocument sidecar = TestData.Json(name + ".json");
        JsonElement facts = sidecar.RootElement;

        Assert.Equal(name.StartsWith("px4", StringComparison.Ordinal) ? MavAutopilot.Px4 : MavAutopilot.Ardupilotmega, flight.Autopilot);
        Assert.Equal(MavType.Quadrotor, flight.VehicleType);
        Assert.Equal(((byte)1, (byte)1), (flight.SystemId, flight.ComponentId));
        Assert.Equal(facts.GetProperty("first_us").GetInt64(), flight.FirstUtcMicroseconds);
        Assert.Equal(facts.GetProperty("last_us").GetInt64(), flight.LastUtcMicroseconds);
        Assert.Equal(facts.GetProperty("sequence")[0].GetProperty("frames").GetInt64(), flight.Frames);
        Assert.Equal(Listed(facts, "mode_changes", ModeChange), flight.ModeChanges.Select(Text), StringComparer.Ordinal);
        Assert.Equal(Listed(facts, "command_acks", Acknowledgement), flight.Acknowledgements.Select(Text), StringComparer.Ordinal);
        Assert.Equal(Listed(facts, "statustext", StatusTextOf), flight.StatusTexts.Select(Text), StringComparer.Ordinal);
        AssertRange(facts, "lat", flight.LatitudeDegE7);
        AssertRange(facts, "lon", flight.LongitudeDegE7);
        AssertRange(facts, "alt", flight.AltitudeAmslMillimetres);
        AssertRange(facts, "relative_alt", flight.HeightAboveHomeMillimetres);

        Assert.Equal((0L, 0L, 0L, 0L), (flight.RefusedMessages, flight.Losses, flight.Reboots, flight.HeartbeatsOfOtherAutopilots));
        Assert.Equal((0L, 0L, 0L), (flight.ModeChangesLeftOut, flight.StatusTextsLeftOut, flight.AcknowledgementsLeftOut));
        Assert.True(end.IsConnected);
        Assert.False(end.IsArmed);
        Assert.Equal(0, sent);
    }

    [Theory]
    [InlineData("ardupilot-flight", "STABILIZE GUIDED BRAKE RTL")]
    [InlineData("px4-flight", "AUTO.LOITER AUTO.TAKEOFF AUTO.LOITER POSCTL.ORBIT OFFBOARD AUTO.LOITER AUTO.RTL AUTO.LOITER")]
    public void ModeChanges_RecordedFlight_NamesTheModesInOrder(string name, string modes)
    {
        FlightSummary flight = Replay(name, out _, out _);
        var seen = new List<string>();
        foreach (FlightModeChange change in flight.ModeChanges)
        {
            if (seen.Count == 0 || seen[seen.Count - 1] != change.Mode)
                seen.Add(change.Mode);
        }

        Assert.Equal(modes, string.Join(" ", seen));
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

    private static FlightSummary Replay(string name, out VehicleState end, out int sent)
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
                rig.Push(new LinkFrame { Frame = frame, Index = record.Index, Time = time, UtcMicroseconds = record.TimeMicroseconds });
        }

        rig.Run();
        end = rig.Vehicle;
        sent = rig.Sink.Frames.Count;
        return rig.Manager.Flight;
    }

    private static IEnumerable<string> Listed(JsonElement facts, string list, Func<JsonElement, string> text)
        => facts.GetProperty(list).EnumerateArray().Select(text);

    private static string ModeChange(JsonElement e)
        => Line(
            Number(e, "record"), Number(e, "t_us"), Number(e, "custom_mode"), Number(e, "base_mode"),
            e.GetProperty("armed").GetBoolean(), Number(e, "system_status"));

    private static string Text(FlightModeChange c)
        => Line(c.Record, c.UtcMicroseconds, c.CustomMode, (long)c.BaseMode, c.IsArmed, (long)c.SystemStatus);

    private static string Acknowledgement(JsonElement e)
        => Line(
            Number(e, "record"), Number(e, "t_us"), Number(e, "command"), Number(e, "result"), Number(e, "progress"),
            Number(e, "result_param2"), Number(e, "target_system"), Number(e, "target_component"));

    private static string Text(FlightAcknowledgement a)
        => Line(
            a.Record, a.UtcMicroseconds, (long)a.Command, (long)a.Result, (long)a.Progress,
            (long)a.ResultParam2, (long)a.TargetSystem, (long)a.TargetComponent);

    private static string StatusTextOf(JsonElement e)
        => Line(Number(e, "record"), Number(e, "t_us"), Number(e, "sysid"), Number(e, "compid"), Number(e, "severity"), e.GetProperty("text").GetString()!);

    private static string Text(FlightStatusText t)
        => Line(t.Record, t.UtcMicroseconds, (long)t.SystemId, (long)t.ComponentId, (long)t.Severity, t.Text);

    private static long Number(JsonElement element, string name) => element.GetProperty(name).GetInt64();

    private static string Line(params object[] parts) => string.Join(" ", parts);

    private static void AssertRange(JsonElement facts, string field, FlightRange? range)
    {
        JsonElement listed = facts.GetProperty("global_position_int").GetProperty(field);
        Assert.NotNull(range);
        Assert.Equal((listed.GetProperty("min").GetInt32(), listed.GetProperty("max").GetInt32()), (range.Value.Minimum, range.Value.Maximum));
    }
}
