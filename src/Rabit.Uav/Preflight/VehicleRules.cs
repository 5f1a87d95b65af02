using System;
using System.Collections.Generic;
using System.Globalization;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>The lines about the vehicle, the mission and this computer.</summary>
internal static class VehicleRules
{
    private const double MaxReportAgeSeconds = 5;

    // Heartbeats come once a second.
    private const double MaxHeartbeatAgeSeconds = 3;

    // More than a radio loses that is well within its range.
    private const double MaxMissingFraction = 0.05;

    // Further away it is the home of another start.
    private const double MaxHomeDistanceMetres = 30;

    // File names and logs carry the time; a minute is still the right flight.
    private static readonly TimeSpan MaxClockError = TimeSpan.FromMinutes(1);

    public static IReadOnlyList<PreflightRule> All { get; } =
    [
        new VehicleRule(JudgeLink)
        {
            Name = "link", Pass = "heartbeats, at most 5 % of the frames missing", Warn = "more frames missing",
            Fail = "no heartbeat for 3 s", HowToSet = "check cable, radio and serial rate",
            Reason = "every command goes over it",
        },
        new VehicleRule(JudgePosition)
        {
            Name = "position", Pass = "a fix in three dimensions, and a position, not older than 5 s",
            Fail = "anything less", HowToSet = "wait for satellites, away from buildings",
            Reason = "the mission is flown by position",
        },
        new VehicleRule(JudgeDilution)
        {
            Name = "hdop", Pass = "at most 1.4", Warn = "more",
            HowToSet = "wait for satellites, away from buildings",
            Reason = "ArduPilot arms up to 1.4 (GPS_HDOP_GOOD)",
        },
        new VehicleRule(JudgeEstimator)
        {
            Name = "estimator", Pass = "attitude, velocity and position are estimated",
            Fail = "one of them is not, or satellites contradict it",
            HowToSet = "keep the vehicle still; calibrate compass and accelerometers",
            Reason = "EKF_STATUS_REPORT of ArduPilot, ESTIMATOR_STATUS of PX4",
        },
        new VehicleRule(JudgeHome)
        {
            Name = "home", Pass = "within 30 m of the vehicle", Warn = "farther: it is set again when the vehicle arms",
            HowToSet = "set home where the vehicle stands",
            Reason = "the autopilot returns to it",
        },
        new VehicleRule(JudgeBattery)
        {
            Name = "battery", Pass = "at least limits.minBatteryFractionAtStart of the mission",
            Warn = "not known, with limits.allowUnknownBattery of the mission",
            Fail = "less, or not known", HowToSet = "charge it; without a current sensor calibrate the battery monitor",
            Reason = "the rules of the flight go by what remains",
        },
        new VehicleRule(JudgePicture)
        {
            Name = "picture", Pass = "one within 5 s, or the mission needs no camera", Fail = "none, or older",
            HowToSet = "start the camera, or fly without detection",
            Reason = "a search without pictures finds nothing",
        },
        new VehicleRule(JudgeResolution)
        {
            Name = "resolution",
            Pass = "from the height of the mission the smallest target has the pixels that its detector needs",
            Warn = "less than 5 % more than that; in a group also less: others of it fly lower",
            Fail = "less", HowToSet = "fly lower, or search for larger targets",
            Reason = "pictures in which the smallest target is too small are not searched, and their ground is not seen",
        },
        new VehicleRule(JudgeDisk)
        {
            Name = "disk", Pass = "100 MB free", Fail = "less", HowToSet = "delete old flights",
            Reason = "log and report are the only record of the flight",
        },
        new VehicleRule(JudgeClock)
        {
            Name = "clock", Pass = "within 1 min of the satellites' time", Warn = "farther away",
            HowToSet = "set the clock of this computer",
            Reason = "file names and logs carry its time, and pictures are matched by it",
        },
        new VehicleRule(JudgeSetup)
        {
            Name = "setup", Pass = "written and confirmed, or nothing to write", Fail = "not all of it was confirmed",
            HowToSet = "see the log; --set-failsafes and --upload-fence write it",
            Reason = "what --set-failsafes and --upload-fence wrote",
        },
    ];

    /// <summary>In the place of the parameters, of which Plane has others than Copter.</summary>
    public static PreflightRule OfArdupilotPlane { get; } = new VehicleRule(
        static _ => PreflightJudgement.Fail("not judged: the parameters of Plane are not known here"))
    {
        Name = "plane-failsafes",
        Autopilot = MavAutopilot.Ardupilotmega,
        IsOfFixedWing = true,
        Pass = "never: the operator overrides it once he has checked them",
        Fail = "a fixed wing, always",
        HowToSet = "check THR_FAILSAFE, FS_LONG_ACTN, FS_GCS_ENABL and BATT_FS_LOW_ACT, then override this line",
        Reason = "Plane has other names and values than Copter; its failsafes are its pilot's to check",
    };

    private static PreflightJudgement JudgeLink(PreflightFacts facts)
    {
        if (!facts.Vehicle.IsConnected)
            return PreflightJudgement.Fail("no autopilot connected");
        if (!facts.IsFresh(facts.Vehicle.LastHeartbeatTime, MaxHeartbeatAgeSeconds))
            return PreflightJudgement.Fail("no heartbeat for 3 s");
        long all = facts.FramesIn + facts.FramesMissing;
        double missing = all == 0 ? 0 : (double)facts.FramesMissing / all;
        string text = Text("{0:0.0} % of the frames missing", missing * 100);
        return missing <= MaxMissingFraction ? PreflightJudgement.Pass(text) : PreflightJudgement.Warn(text);
    }

    private static PreflightJudgement JudgePosition(PreflightFacts facts)
    {
        string fix = facts.Vehicle.GpsTime is null
            ? "no fix reported"
            : $"{facts.Vehicle.GpsFix}, {Satellites(facts.Vehicle.Satellites)} satellites";
        if (facts.Vehicle.GpsFix < GpsFixType.Type3dFix || !facts.IsFresh(facts.Vehicle.GpsTime, MaxReportAgeSeconds))
            return PreflightJudgement.Fail(fix);
        return facts.IsFresh(facts.Vehicle.PositionTime, MaxReportAgeSeconds)
            ? PreflightJudgement.Pass(fix)
            : PreflightJudgement.Fail(fix + ", but no position");
    }

    private static PreflightJudgement JudgeDilution(PreflightFacts facts)
    {
        double value = facts.Navigation.HorizontalDilution;
        if (!facts.IsFresh(facts.Navigation.DilutionTime, MaxReportAgeSeconds) || double.IsNaN(value))
            return PreflightJudgement.Unknown();
        string text = Text("{0:0.00}", value);
        return value <= facts.Options.MaxHorizontalDilution
            ? PreflightJudgement.Pass(text)
            : PreflightJudgement.Warn(text);
    }

    private static PreflightJudgement JudgeEstimator(PreflightFacts facts)
    {
        if (!facts.IsFresh(facts.Navigation.EstimatorTime, MaxReportAgeSeconds))
            return PreflightJudgement.Unknown();
        return facts.Navigation.EstimatorFault is { } fault
            ? PreflightJudgement.Fail(fault)
            : PreflightJudgement.Pass("attitude, velocity and position");
    }

    private static PreflightJudgement JudgeHome(PreflightFacts facts)
    {
        if (facts.Navigation.HomeTime is null || facts.Vehicle.PositionTime is null)
            return PreflightJudgement.Unknown();
        NedPosition off = LocalNedFrame.IgnoringGeoid(facts.Vehicle.Position).ToNed(facts.Navigation.Home);
        double distance = Math.Sqrt((off.North * off.North) + (off.East * off.East));
        string text = Text("{0:0} m from the vehicle", distance);
        return distance <= MaxHomeDistanceMetres ? PreflightJudgement.Pass(text) : PreflightJudgement.Warn(text);
    }

    private static PreflightJudgement JudgeBattery(PreflightFacts facts)
    {
        double remaining = facts.Vehicle.BatteryTime is null ? double.NaN : facts.Vehicle.BatteryRemaining;
        string volts = double.IsNaN(facts.Vehicle.BatteryVolts) || facts.Vehicle.BatteryTime is null
            ? string.Empty
            : Text(", {0:0.0} V", facts.Vehicle.BatteryVolts);
        if (double.IsNaN(remaining))
        {
            string unknown = "remaining charge not known" + volts;
            return facts.Options.AllowsUnknownBattery
                ? PreflightJudgement.Warn(unknown)
                : PreflightJudgement.Fail(unknown);
        }

        string text = Text("{0:0} %", remaining * 100) + volts;
        return remaining >= facts.Options.MinBatteryFraction
            ? PreflightJudgement.Pass(text)
            : PreflightJudgement.Fail(
                text + Text("; {0:0} % are needed", facts.Options.MinBatteryFraction * 100));
    }

    private static PreflightJudgement JudgePicture(PreflightFacts facts)
    {
        if (!facts.Options.RequiresCamera)
            return PreflightJudgement.Pass("no camera needed");
        if (!facts.Imaging.HasCamera)
            return PreflightJudgement.Fail("no camera");
        if (facts.Imaging.LastFrameTime is not { } last)
            return PreflightJudgement.Fail(
                facts.Imaging.Fault is { } fault ? "no picture yet: " + fault : "no picture yet");
        string text = Text("{0:0} s ago", Math.Floor((facts.Now - last).ExactSeconds));
        return facts.Now - last <= facts.Options.MaxPictureAge
            ? PreflightJudgement.Pass(text)
            : PreflightJudgement.Fail(text);
    }

    private static PreflightJudgement JudgeResolution(PreflightFacts facts)
    {
        if (facts.Options.Resolution is not { } resolution)
            return PreflightJudgement.Pass("no smallest target");
        string text = resolution.ToString();
        return resolution.IsTooCoarse && !facts.Options.IsInGroup ? PreflightJudgement.Fail(text)
            : resolution.IsScarce ? PreflightJudgement.Warn(text)
            : PreflightJudgement.Pass(text);
    }

    private static PreflightJudgement JudgeDisk(PreflightFacts facts)
    {
        if (facts.Computer.DiskFreeBytes is not { } free)
            return PreflightJudgement.Unknown("not determined");
        string text = Text("{0:0} MB free", Math.Floor(free / 1e8) * 100);
        return free >= facts.Options.MinFreeDiskBytes ? PreflightJudgement.Pass(text) : PreflightJudgement.Fail(text);
    }

    private static PreflightJudgement JudgeClock(PreflightFacts facts)
    {
        if (facts.Options.UtcNow is not { } utcNow || facts.Vehicle.UtcTime is not { } reported
            || facts.Vehicle.GpsUtcMicroseconds <= 0)
            return PreflightJudgement.Unknown("no time of satellites to compare with");
        DateTimeOffset satellites = DateTimeOffset.FromUnixTimeMilliseconds(
            facts.Vehicle.GpsUtcMicroseconds / 1000) + (facts.Now - reported);
        TimeSpan off = (utcNow() - satellites).Duration();
        return off <= MaxClockError
            ? PreflightJudgement.Pass("within 1 min of the satellites' time")
            : PreflightJudgement.Warn(Text("{0:0} min off the satellites' time", off.TotalMinutes));
    }

    private static PreflightJudgement JudgeSetup(PreflightFacts facts) => facts.Parameters.Setup switch
    {
        AutopilotSetupState.None or AutopilotSetupState.Done or AutopilotSetupState.Restored
            => PreflightJudgement.Pass(facts.Parameters.SetupText ?? "nothing to write"),
        AutopilotSetupState.Failed => PreflightJudgement.Fail(facts.Parameters.SetupText ?? "failed"),
        _ => PreflightJudgement.Fail(facts.Parameters.SetupText ?? "being written"),
    };

    private static string Satellites(int count)
        => count == byte.MaxValue ? "?" : count.ToString(CultureInfo.InvariantCulture);

    private static string Text(string format, double value)
        => string.Format(CultureInfo.InvariantCulture, format, value);
}
