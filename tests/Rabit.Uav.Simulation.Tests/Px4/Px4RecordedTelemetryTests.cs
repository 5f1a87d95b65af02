using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Px4;

/// <summary>
/// What a companion sent to the real PX4 in px4-flight.tlog is sent to the simulated one at the same times: take-off,
/// DO_REPOSITION, orbit, OFFBOARD by velocity, return, landing.
/// </summary>
public class Px4RecordedTelemetryTests(ITestOutputHelper output)
{
    private const byte Companion = 191;
    private const double MetresPerDegE7 = 0.0111;
    private const double CosineOfLatitude = 0.70;
    private const double OrbitBegins = 45.9;
    private const double OffboardBegins = 102;   // some seconds after, wherever on the circle it began
    private const double ReturnBegins = 112;

    [Fact]
    public void RecordedCommands_SentAgain_AreAnsweredAndFlownAboutTheSame()
    {
        List<(double Time, MavlinkFrame Frame)> record = ReadRecord();
        GlobalPositionInt start = All<GlobalPositionInt>(record).First().Message;
        var flyer = new Px4Flyer(
            GeodeticPosition.FromDegrees(start.Lat * 1e-7, start.Lon * 1e-7, start.Alt * 1e-3), -2);
        flyer.Run(2);
        foreach ((double time, MavlinkFrame frame) in record.Where(r => r.Frame.ComponentId == Companion))
        {
            flyer.RunUntil(() => flyer.Time >= time, 100, "the next frame");
            flyer.Vehicle.Handle(frame, TimeSpan.FromSeconds(flyer.Time + 2));
            flyer.Step();
        }

        flyer.Run(30);
        List<(double Time, MavlinkFrame Frame)> simulated = flyer.Frames(0).ToList();
        Assert.Equal(Answers(record), Answers(simulated));
        Assert.Equal(Modes(record), Modes(simulated));
        double apart = Apart(record, simulated, 0, OrbitBegins);
        double inOffboard = Apart(record, simulated, OffboardBegins, ReturnBegins);
        double disarmed = DisarmTime(simulated) - DisarmTime(record);
        output.WriteLine($"{apart:0.0} m apart, {inOffboard:0.0} m in OFFBOARD; disarmed {disarmed:0.0} s later");

        // The real one gains speed more slowly on a leg of 60 m.
        Assert.True(apart < 15, $"{apart:0.0} m apart before the orbit");
        Assert.True(inOffboard < 5, $"{inOffboard:0.0} m apart in OFFBOARD");
        Assert.InRange(disarmed, -10, 10);
    }

    private static double Apart(
        List<(double Time, MavlinkFrame Frame)> record, List<(double Time, MavlinkFrame Frame)> simulated,
        double from, double to)
    {
        double worst = 0;
        List<(double Time, GlobalPositionInt Message)> flown = All<GlobalPositionInt>(simulated);
        foreach ((double time, GlobalPositionInt there)
            in All<GlobalPositionInt>(record).Where(r => r.Time > from && r.Time < to))
        {
            GlobalPositionInt here = flown.Last(s => s.Time <= time).Message;
            double north = (there.Lat - here.Lat) * MetresPerDegE7;
            double east = (there.Lon - here.Lon) * MetresPerDegE7 * CosineOfLatitude;
            worst = Math.Max(worst, Math.Sqrt((north * north) + (east * east)));
        }

        return worst;
    }

    private static string[] Answers(IEnumerable<(double Time, MavlinkFrame Frame)> frames)
        => All<CommandAck>(frames).Select(a => $"{a.Message.Command} {a.Message.Result}").ToArray();

    private static string[] Modes(IEnumerable<(double Time, MavlinkFrame Frame)> frames)
    {
        string[] all = All<Heartbeat>(frames.Where(f => f.Frame.ComponentId == 1))
            .Select(h => $"{h.Message.CustomMode:x} {(int)h.Message.BaseMode} {h.Message.SystemStatus}").ToArray();
        return all.Where((m, i) => i == 0 || all[i - 1] != m).ToArray();
    }

    private static double DisarmTime(IEnumerable<(double Time, MavlinkFrame Frame)> frames)
        => All<Heartbeat>(frames.Where(f => f.Frame.ComponentId == 1))
            .Last(h => (h.Message.BaseMode & MavModeFlag.SafetyArmed) != 0).Time;

    private static List<(double Time, T Message)> All<T>(IEnumerable<(double Time, MavlinkFrame Frame)> frames)
        where T : struct, IMavlinkMessage
    {
        var all = new List<(double, T)>();
        foreach ((double time, MavlinkFrame frame) in frames)
        {
            if (frame.TryDecode(out T message))
                all.Add((time, message));
        }

        return all;
    }

    private static List<(double Time, MavlinkFrame Frame)> ReadRecord()
    {
        using FileStream file = File.OpenRead(
            Path.Combine(AppContext.BaseDirectory, "data", "mavlink", "px4-flight.tlog"));
        var reader = new TlogReader(file, MavlinkDialect.All);
        var frames = new List<(double, MavlinkFrame)>();
        DateTime? start = null;
        while (reader.TryRead(out MavlinkFrame frame, out TlogRecord record))
        {
            start ??= record.TimeUtc;
            frames.Add(((record.TimeUtc - start.Value).TotalSeconds, frame));
        }

        return frames;
    }
}
