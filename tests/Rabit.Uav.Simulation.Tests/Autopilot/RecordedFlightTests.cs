using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Autopilot;

/// <summary>
/// The yardstick: what a companion sent to the real ArduCopter in a recorded flight is sent to the simulated one at the
/// same times. It must answer alike, go through the same modes, and fly about the same.
/// </summary>
public class RecordedFlightTests(ITestOutputHelper output)
{
    private const byte Companion = 191;
    private const double MetresPerDegE7 = 0.0111;
    private const double CosineOfLatitude = 0.815;

    // From the record: "EKF3 IMU0 is using GPS".
    private static readonly TimeSpan PositionAfter = TimeSpan.FromSeconds(11.9);

    [Fact]
    public void RecordedCommands_SentAgain_AreAnsweredAsByTheRealOne()
    {
        List<(TimeSpan Time, MavlinkFrame Frame)> record = ReadRecord();
        using var ground = new Ground(new SimulationOptions { PositionAfter = PositionAfter, WindMetresPerSecond = 0 });
        Replay(ground, record);

        Assert.Equal(Acknowledgements(record), Acknowledgements(ground.Frames));
        Assert.Equal(Modes(record), Modes(ground.Frames));
        Assert.Equal(Texts(record).Where(IsCommon).ToArray(), Texts(ground.Frames).Where(IsCommon).ToArray());
    }

    [Fact]
    public void RecordedCommands_SentAgain_FlyAboutTheSame()
    {
        List<(TimeSpan Time, MavlinkFrame Frame)> record = ReadRecord();
        using var ground = new Ground(new SimulationOptions { PositionAfter = PositionAfter, WindMetresPerSecond = 0 });
        ground.Stream(GlobalPositionInt.MavlinkId, 10);
        ground.Stream(Attitude.MavlinkId, 25);
        Replay(ground, record);

        List<(TimeSpan Time, GlobalPositionInt Message)> real = All<GlobalPositionInt>(record);
        List<(TimeSpan Time, GlobalPositionInt Message)> simulated = All<GlobalPositionInt>(ground.Frames);
        double inGuided = Apart(real, simulated, 15, 110);
        double inReturn = Apart(real, simulated, 110, 160);
        double disarmed = DisarmTime(ground.Frames) - DisarmTime(record);
        output.WriteLine(
            $"{inGuided:0.0} m apart at most in GUIDED, {inReturn:0.0} m then; disarmed {disarmed:0.0} s later");
        output.WriteLine($"tilt: real {Tilt(record):0.0}, simulated {Tilt(ground.Frames):0.0} degrees");
        Assert.True(inGuided < 4, $"{inGuided:0.0} m apart in GUIDED");

        // The real one sets out and waits above home by some seconds longer.
        Assert.True(inReturn < 15, $"{inReturn:0.0} m apart on the return");
        Assert.InRange(disarmed, -10, 10);
        Assert.InRange(Tilt(ground.Frames) / Tilt(record), 0.5, 2);
    }

    private static double Apart(
        List<(TimeSpan Time, GlobalPositionInt Message)> real,
        List<(TimeSpan Time, GlobalPositionInt Message)> simulated, double from, double to)
    {
        double worst = 0;
        foreach ((TimeSpan time, GlobalPositionInt there)
            in real.Where(r => r.Time.TotalSeconds > from && r.Time.TotalSeconds < to))
        {
            GlobalPositionInt here = simulated.Last(s => s.Time <= time).Message;
            double north = Math.Abs(there.Lat - here.Lat) * MetresPerDegE7;
            double east = Math.Abs(there.Lon - here.Lon) * MetresPerDegE7 * CosineOfLatitude;
            worst = Math.Max(
                worst, Math.Max(Math.Max(north, east), Math.Abs(there.RelativeAlt - here.RelativeAlt) / 1000.0));
        }

        return worst;
    }

    private static void Replay(Ground ground, List<(TimeSpan Time, MavlinkFrame Frame)> record)
    {
        foreach ((TimeSpan time, MavlinkFrame frame) in record.Where(r => r.Frame.ComponentId == Companion))
        {
            if (time > ground.Now)
                ground.Run((time - ground.Now).TotalSeconds);
            byte[] bytes = new byte[frame.WireLength];
            frame.WriteTo(bytes);
            ground.Link.Write(bytes, 0, bytes.Length);
        }

        ground.Run(20);
    }

    private static List<(TimeSpan Time, MavlinkFrame Frame)> ReadRecord()
    {
        using FileStream file = File.OpenRead(
            Path.Combine(AppContext.BaseDirectory, "data", "mavlink", "ardupilot-flight.tlog"));
        var reader = new TlogReader(file, MavlinkDialect.All);
        var frames = new List<(TimeSpan, MavlinkFrame)>();
        DateTime? start = null;
        while (reader.TryRead(out MavlinkFrame frame, out TlogRecord record))
        {
            start ??= record.TimeUtc;
            frames.Add((record.TimeUtc - start.Value, frame));
        }

        return frames;
    }

    private static string[] Acknowledgements(IEnumerable<(TimeSpan Time, MavlinkFrame Frame)> frames)
        => All<CommandAck>(frames).Where(a => a.Message.TargetComponent == Companion)
            .Select(a => $"{a.Message.Command} {a.Message.Result} {a.Message.TargetSystem}/{a.Message.TargetComponent}")
            .ToArray();

    private static string[] Modes(IEnumerable<(TimeSpan Time, MavlinkFrame Frame)> frames)
    {
        string[] all = All<Heartbeat>(frames.Where(f => f.Frame.ComponentId == 1))
            .Select(h => $"{(CopterMode)h.Message.CustomMode} {(int)h.Message.BaseMode}").ToArray();
        return all.Where((m, i) => i == 0 || all[i - 1] != m).ToArray();
    }

    private static IEnumerable<string> Texts(IEnumerable<(TimeSpan Time, MavlinkFrame Frame)> frames)
        => All<Statustext>(frames).Select(t => t.Message.Severity + " " + t.Message.Text);

    // What depends on the real one's sensors is not simulated.
    private static bool IsCommon(string text)
        => text.IndexOf("MAG0", StringComparison.Ordinal) < 0 && text.IndexOf("SIM Hit", StringComparison.Ordinal) < 0;

    private static double DisarmTime(IEnumerable<(TimeSpan Time, MavlinkFrame Frame)> frames)
        => All<Statustext>(frames).First(t => t.Message.Text.ToString() == "Disarming motors").Time.TotalSeconds;

    private static double Tilt(IEnumerable<(TimeSpan Time, MavlinkFrame Frame)> frames)
        => All<Attitude>(frames).Max(a => Math.Max(Math.Abs(a.Message.Roll), Math.Abs(a.Message.Pitch)))
            / Ground.RadiansPerDegree;

    private static List<(TimeSpan Time, T Message)> All<T>(IEnumerable<(TimeSpan Time, MavlinkFrame Frame)> frames)
        where T : struct, IMavlinkMessage
    {
        var all = new List<(TimeSpan, T)>();
        foreach ((TimeSpan time, MavlinkFrame frame) in frames)
        {
            if (frame.TryDecode(out T message))
                all.Add((time, message));
        }

        return all;
    }
}
