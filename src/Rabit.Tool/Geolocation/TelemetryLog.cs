using System;
using System.Collections.Generic;
using System.IO;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Tool.Geolocation;

/// <summary>
/// A telemetry log of MAVLink: GLOBAL_POSITION_INT and ATTITUDE of the first autopilot in it, by that autopilot's
/// clock, and what a gimbal of its vehicle reports; of one run of the autopilot, where it started more than once.
/// </summary>
internal static class TelemetryLog
{
    // No autopilot has run for 30 years: such a time is one of the log's stamps.
    private const double EarliestUtcSeconds = 1e9;
    private const double RadiansPerDegE7 = Angle.RadiansPerDegree * 1e-7;

    /// <param name="file">The log.</param>
    /// <param name="time">Seconds since the autopilot started, or since 1970 by the stamps of the log.</param>
    /// <param name="beyond">How much later than the time is still of use.</param>
    /// <param name="locator">Takes the poses.</param>
    /// <param name="usesGimbal">Whether it takes the gimbal's attitude too.</param>
    /// <returns>The time since the autopilot started.</returns>
    /// <exception cref="FormatException">There are no positions or no attitudes in it.</exception>
    public static TimeSpan Read(
        string file, TimeSpan time, TimeSpan beyond, PixelGeolocator locator, bool usesGimbal)
    {
        int boot = BootOf(file, ref time);
        var boots = new LoggedBoots();
        var sent = new HashSet<PoseSampleKind>();
        var gimbal = new LoggedGimbal();
        TimeSpan stampsLessBoot = TimeSpan.MaxValue;
        foreach (LoggedFrame logged in Frames(file))
        {
            boots.Take(logged);
            if (Math.Max(1, boots.Count) < boot)
                continue;
            if (boots.Count > boot)
                break;
            if (usesGimbal)
                gimbal.Take(logged);
            if (!logged.IsOfAutopilot || !TryPose(logged.Frame, out PoseSample sample))
                continue;
            locator.Add(sample);
            sent.Add(sample.Kind);
            stampsLessBoot = Least(stampsLessBoot, logged.Stamp - sample.Time);
            if (sample.Time > time + beyond)
                break;
        }

        if (sent.Count < 2)
            throw new FormatException($"{file} has no positions or no attitudes of an autopilot.");
        gimbal.AddTo(locator, stampsLessBoot);
        return time;
    }

    // Which run of the autopilot the time is of; since its start.
    private static int BootOf(string file, ref TimeSpan time)
    {
        var boots = new LoggedBoots();
        foreach (LoggedFrame logged in Frames(file))
            boots.Take(logged);
        if (time.TotalSeconds < EarliestUtcSeconds)
            return Math.Max(1, boots.At(time, file));
        (int boot, time) = boots.AtStamp(time, file);
        return boot;
    }

    private static TimeSpan Least(TimeSpan a, TimeSpan b) => a < b ? a : b;

    // Those of the vehicle of the first autopilot, from where that is known.
    private static IEnumerable<LoggedFrame> Frames(string file)
    {
        using FileStream stream = File.OpenRead(file);
        using ProgressBar progress = ProgressBar.Start(stream.CanSeek ? stream.Length : 0);
        var log = new TlogReader(stream, MavlinkDialect.All);
        (byte System, byte Component)? autopilot = null;
        while (log.TryRead(out MavlinkFrame frame, out TlogRecord record))
        {
            progress.Show(log.Position);
            if (autopilot is null && frame.TryDecode(out Heartbeat beat) && beat.Autopilot != MavAutopilot.Invalid)
                autopilot = (frame.SystemId, frame.ComponentId);
            if (autopilot?.System == frame.SystemId)
                yield return new LoggedFrame(
                    frame, TimeSpan.FromTicks(record.TimeMicroseconds * 10),
                    IsOfAutopilot: autopilot?.Component == frame.ComponentId);
        }
    }

    private static bool TryPose(in MavlinkFrame frame, out PoseSample sample)
    {
        sample = default;
        if (frame.MessageId == GlobalPositionInt.MavlinkId && frame.TryDecode(out GlobalPositionInt p)
            && (p.Lat != 0 || p.Lon != 0))
        {
            sample.Kind = PoseSampleKind.Position;
            sample.Time = TimeSpan.FromMilliseconds(p.TimeBootMs);
            sample.Position = GeodeticPosition.FromRadians(
                p.Lat * RadiansPerDegE7, p.Lon * RadiansPerDegE7, p.Alt / 1000.0);
            sample.VelocityNed = new NedVector(p.Vx / 100.0, p.Vy / 100.0, p.Vz / 100.0);
            return true;
        }

        if (frame.MessageId != Attitude.MavlinkId || !frame.TryDecode(out Attitude a))
            return false;
        sample.Kind = PoseSampleKind.Attitude;
        sample.Time = TimeSpan.FromMilliseconds(a.TimeBootMs);
        sample.Attitude = EulerAngles.FromRadians(a.Roll, a.Pitch, a.Yaw);
        sample.Rates = BodyRates.FromRadiansPerSecond(a.Rollspeed, a.Pitchspeed, a.Yawspeed);
        return true;
    }
}
