using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Tests;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>
/// The recorder beside all managers on the recorded flights, compared with the facts listed beside them.
/// </summary>
public sealed class ReplayTests
{
    [Theory]
    [InlineData("ardupilot-flight", MavAutopilot.Ardupilotmega)]
    [InlineData("px4-flight", MavAutopilot.Px4)]
    public void Telemetry_RecordedFlight_AgreesWithTheSidecar(string name, MavAutopilot autopilot)
    {
        TelemetryRecord telemetry = Replay(name, seed: 0);
        using JsonDocument sidecar = TestData.Json(name + ".json");
        JsonElement facts = sidecar.RootElement;

        TelemetryFacts.AssertAgrees(facts, telemetry);
        Assert.Equal((autopilot, MavType.Quadrotor), (telemetry.Autopilot, telemetry.VehicleType));
        Assert.Equal(((byte)1, (byte)1), (telemetry.SystemId, telemetry.ComponentId));
        Assert.Equal(facts.GetProperty("sequence")[0].GetProperty("frames").GetInt64(), telemetry.Frames);
        Assert.Equal(
            (0L, 0L, 0L, 0L),
            (telemetry.FramesDropped, telemetry.ModeChangesLeftOut, telemetry.StatusTextsLeftOut,
                telemetry.AcknowledgementsLeftOut));
    }

    [Theory]
    [InlineData("ardupilot-flight", "STABILIZE GUIDED BRAKE RTL")]
    [InlineData("px4-flight",
        "AUTO.LOITER AUTO.TAKEOFF AUTO.LOITER POSCTL.ORBIT OFFBOARD AUTO.LOITER AUTO.RTL AUTO.LOITER")]
    public void ModeChanges_RecordedFlight_NamesTheModesInOrder(string name, string modes)
    {
        var names = new List<string>();
        foreach (FlightModeChange change in Replay(name, seed: 0).ModeChanges)
        {
            if (names.Count == 0 || names[names.Count - 1] != change.Mode)
                names.Add(change.Mode);
        }

        Assert.Equal(modes, string.Join(" ", names));
    }

    [Theory]
    [InlineData("ardupilot-flight")]
    [InlineData("px4-flight")]
    public void Telemetry_AnySeedAndAnySpeed_IsTheSame(string name)
    {
        IEnumerable<string> expected = TelemetryFacts.Describe(Replay(name, seed: 0));

        for (int seed = 1; seed <= 3; seed++)
            Assert.Equal(expected, TelemetryFacts.Describe(Replay(name, seed)));
        Assert.Equal(expected, TelemetryFacts.Describe(Replay(name, seed: 0, speed: "1000")));
    }

    private static TelemetryRecord Replay(string name, long seed, string speed = "max")
    {
        using UavSystem uav = UavSystem.Open(new UavOptions
        {
            Links = [LinkUrl.Parse($"tlog:{TestData.PathOf(name + ".tlog")}?speed={speed}")],
            Seed = seed,
            Subscriptions = [FlightRecorderManager.CreateSubscription()],
        });
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions { StopsOnSignals = false });
        var recorder = new FlightRecorderManager(new FlightRecorderOptions());
        reactor.Add(recorder);
        Assert.Equal(0, reactor.Run().ExitCode);
        return recorder.Record.Telemetry;
    }
}
