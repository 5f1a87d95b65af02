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
/// clock.
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
    /// <returns>The time since the autopilot started.</returns>
    /// <exception cref="FormatException">There are no positions or no attitudes in it.</exception>
    public static TimeSpan Read(string file, TimeSpan time, TimeSpan beyond, PixelGeolocator locator)
    {
        if (time.TotalSeconds >= EarliestUtcSeconds)
            time -= StampsLessBoot(file);
        var sent = new HashSet<PoseSampleKind>();
        foreach ((PoseSample sample, _) in Samples(file))
        {
            locator.Add(sample);
            sent.Add(sample.Kind);
            if (sample.Time > time + beyond)
                break;
        }

        return sent.Count == 2
            ? time
            : throw new FormatException($"{file} has no positions or no attitudes of an autopilot.");
    }

    // By the message that was quickest: late by the shortest delay of the link, which is not in a log.
    private static TimeSpan StampsLessBoot(string file)
    {
        TimeSpan least = TimeSpan.MaxValue;
        foreach ((PoseSample sample, TimeSpan stamp) in Samples(file))
        {
            if (stamp - sample.Time < least)
                least = stamp - sample.Time;
        }

        return least < TimeSpan.MaxValue
            ? least
            : throw new FormatException($"{file} has no positions or attitudes of an autopilot.");
    }

    private static IEnumerable<(PoseSample Sample, TimeSpan Stamp)> Samples(string file)
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
            if (autopilot == (frame.SystemId, frame.ComponentId) && TryPose(frame, out PoseSample sample))
                yield return (sample, TimeSpan.FromTicks(record.TimeMicroseconds * 10));
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
