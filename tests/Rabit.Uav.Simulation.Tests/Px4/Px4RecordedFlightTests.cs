using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Px4;

/// <summary>
/// The yardstick: what was done to the real PX4 in recorded flights is done to the simulated one at the same times. It
/// must answer alike, go through the same modes and landed states, and report the same failsafes, takeovers and
/// refusals, at times within 20 % of those since what caused them.
/// </summary>
public class Px4RecordedFlightTests(ITestOutputHelper output)
{
    private const double Part = 0.2;
    private const double MinSeconds = 0.3;
    private const double LoadSeconds = 1.5;   // the real one looks at its load when it comes to it
    private const double ClimbSeconds = 0.8;   // of a climb by 2 m
    private const double Instant = 0.02;   // an event that a failsafe begins with is not caused by it

    private static readonly string[] Starts =
        ["Armed", "Disarmed", "Pilot", "Failsafe", "Preflight Fail: Geo", "RTL HOME", "GCS"];

    public static TheoryData<string> Names => new()
    {
        "px4-offboard", "px4-offboard-takeover", "px4-mode-race", "px4-mode-race-5hz", "px4-offboard-stream-stop",
        "px4-offboard-stream-resume", "px4-stick-override", "px4-link-loss", "px4-battery-warn", "px4-battery-return",
        "px4-texts", "px4-geofence", "px4-reposition-takeover", "px4-gps-loss",
    };

    private static IReadOnlyList<Px4Event> LeftOut =>
        [Px4Event.NoGroundConnection, Px4Event.PositionError, Px4Event.BatteryIsLow];

    [Theory]
    [MemberData(nameof(Names))]
    public void RecordedActions_DoneAgain_AreAnsweredAndFollowedAsByTheRealOne(string name)
    {
        Px4Recording recording = Px4Recording.Read(name);
        Px4Replay replay = new Px4Replay(recording).Run();

        var faults = new List<string>(replay.WrongAnswers);
        Compare(
            "mode", recording.Modes.ToList(), replay.StatesAtHeartbeats(), recording, faults,
            recording.HeartbeatPeriod + MinSeconds);
        Compare("landed state", recording.LandedStates.ToList(), LandedStates(replay), recording, faults, 1.2);
        Compare("event", RecordedEvents(recording).ToList(), Events(replay), recording, faults, MinSeconds);
        CompareTexts(recording, replay, faults);
        foreach (string fault in faults)
            output.WriteLine(fault);
        Assert.Empty(faults);
    }

    private static void Compare(
        string what, List<(double Time, string State)> real, List<(double Time, string State)> simulated,
        Px4Recording recording, List<string> faults, double leastSeconds)
    {
        if (!real.Select(r => r.State).SequenceEqual(simulated.Select(s => s.State)))
        {
            faults.Add($"{what}s: recorded {Text(real)}");
            faults.Add($"{what}s: simulated {Text(simulated)}");
            return;
        }

        for (int index = 0; index < real.Count; index++)
        {
            double time = real[index].Time;
            IEnumerable<double> causes = IsPartOfFlight(real[index].State) ? recording.ModeChanges : recording.Causes;
            double cause = causes.Where(c => c <= time - Instant).DefaultIfEmpty(0).Max();
            double allowed = Math.Max(Math.Max(leastSeconds, Least(real[index].State)), Part * (time - cause));
            double apart = simulated[index].Time - time;
            if (Math.Abs(apart) > allowed)
                faults.Add(FormattableString.Invariant(
                    $"{what} {real[index].State}: {time:0.00} s, {apart:+0.00;-0.00} s; {allowed:0.00} allowed"));
        }
    }

    private static double Least(string state) => state switch
    {
        nameof(Px4Event.LoadTooHigh) => LoadSeconds,
        nameof(Px4Event.ReturnFlies) => ClimbSeconds,
        _ => 0,
    };

    // What follows from the mode alone, whatever was done since.
    private static bool IsPartOfFlight(string state)
        => state.StartsWith("Return", StringComparison.Ordinal) || state.StartsWith("Landing", StringComparison.Ordinal)
            || state.StartsWith("DisarmedBy", StringComparison.Ordinal) || state is "LANDING" or "ON_GROUND"
            || state.EndsWith(" 3", StringComparison.Ordinal);

    private static string Text(IEnumerable<(double Time, string State)> states)
        => string.Join(", ", states.Select(s => FormattableString.Invariant($"{s.Time:0.0} {s.State}")));

    private static IEnumerable<(double Time, string Name)> RecordedEvents(Px4Recording recording)
        => recording.Events.Where(e => e.Time >= 0 && IsCompared(e.Id))
            .Select(e => (e.Time, Name(e.Id, e.Arguments)));

    private static List<(double Time, string Name)> Events(Px4Replay replay) => replay.Frames(0)
        .Where(f => f.Time >= 0 && f.Frame.MessageId == Event.MavlinkId)
        .Select(f =>
        {
            f.Frame.TryDecode(out Event message);
            string arguments = string.Concat(Enumerable.Range(0, 40).Select(i => message.Arguments[i].ToString("x2")));
            return (f.Time, message.Id, Arguments: arguments);
        })
        .Where(e => IsCompared(e.Id)).Select(e => (e.Time, Name(e.Id, e.Arguments))).ToList();

    // With its arguments, where they say what a failsafe does and why, or who armed it.
    private static string Name(uint id, string arguments)
    {
        var known = (Px4Event)id;
        bool hasArguments = known is Px4Event.Failsafe or Px4Event.FailsafeGeneric or Px4Event.FailsafeHold
            or Px4Event.FailsafeGenericHold or Px4Event.FailsafeWarning or Px4Event.ArmedBy or Px4Event.DisarmedBy
            or Px4Event.TransitionDenied or Px4Event.FenceViolation or Px4Event.BatteryIsLow;
        return hasArguments ? $"{known} {arguments.Substring(0, 16)}" : known.ToString();
    }

    private static List<(double Time, string Name)> LandedStates(Px4Replay replay)
    {
        var states = new List<(double Time, string Name)>();
        foreach ((double time, Rabit.Mavlink.MavlinkFrame frame) in replay.Frames(0))
        {
            if (time < 0 || !frame.TryDecode(out ExtendedSysState state))
                continue;
            string name = state.LandedState switch
            {
                MavLandedState.OnGround => "ON_GROUND",
                MavLandedState.InAir => "IN_AIR",
                MavLandedState.Takeoff => "TAKEOFF",
                _ => "LANDING",
            };
            if (states.Count == 0 || states[states.Count - 1].Name != name)
                states.Add((time, name));
        }

        return states;
    }

    // Of arming, take-off, landing, takeovers and failsafes; each once, since the real one repeats some.
    private static void CompareTexts(Px4Recording recording, Px4Replay replay, List<string> faults)
    {
        string[] simulated = replay.Frames(1).Where(f => f.Time > 0 && f.Frame.MessageId == Statustext.MavlinkId)
            .Select(f => f.Frame.TryDecode(out Statustext text) ? text.Text.ToString().Trim() : string.Empty)
            .Where(IsCompared).Distinct().OrderBy(t => t, StringComparer.Ordinal).ToArray();
        string[] real = recording.Texts.Where(IsCompared).Distinct().OrderBy(t => t, StringComparer.Ordinal).ToArray();
        if (!real.SequenceEqual(simulated))
            faults.Add($"texts: recorded {string.Join(" | ", real)}; simulated {string.Join(" | ", simulated)}");
    }

    // Those that the model has; what it leaves out is in docs/concepts/simulation.md.
    private static bool IsCompared(uint id)
        => !char.IsDigit(((Px4Event)id).ToString()[0]) && !LeftOut.Contains((Px4Event)id);

    private static bool IsCompared(string text)
        => text.EndsWith("detected", StringComparison.Ordinal)
            || Starts.Any(s => text.StartsWith(s, StringComparison.Ordinal));
}
