using System;
using System.Globalization;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Words and figures of a flight for people, the same in every culture: what the summary, the report and a screen
/// have in common.
/// </summary>
public static class FlightText
{
    /// <summary>A number; a dash where it is not known. What is rounded to zero has no sign.</summary>
    /// <param name="value">NaN and infinity are not known.</param>
    /// <param name="format">A format of .NET.</param>
    public static string Number(double value, string format = "0.##")
    {
        if (double.IsNaN(value) || double.IsInfinity(value))
            return "–";
        string text = value.ToString(format, CultureInfo.InvariantCulture);
        return text[0] == '-' && !text.Any(c => c is >= '1' and <= '9') ? text.Substring(1) : text;   // no "-0"
    }

    /// <summary>A whole number.</summary>
    /// <param name="value">The number.</param>
    public static string Number(long value) => value.ToString(CultureInfo.InvariantCulture);

    /// <summary>Minutes and seconds, <c>12:05</c>.</summary>
    /// <param name="time">By the clock of the run.</param>
    public static string Clock(TimeSpan time)
        => string.Format(CultureInfo.InvariantCulture, "{0}:{1:00}", (long)Math.Floor(time.TotalMinutes), time.Seconds);

    /// <summary>Seconds in a column of 12 characters, to begin a line with.</summary>
    /// <param name="time">By the clock of the run.</param>
    public static string TimeStamp(TimeSpan time)
        => string.Format(CultureInfo.InvariantCulture, "{0,10:0.000}  ", time.TotalSeconds);

    /// <summary>
    /// A text from outside without what breaks a line, controls a terminal or turns the direction of writing: a dot
    /// in its place.
    /// </summary>
    /// <param name="text">The text.</param>
    public static string Printable(string text)
        => new((text ?? throw new ArgumentNullException(nameof(text))).Select(c => IsControl(c) ? '.' : c).ToArray());

    /// <summary>The level, and the text where there is one.</summary>
    /// <param name="health">The report.</param>
    public static string Health(in HealthReport health)
        => health.Text is null ? health.Level.ToString() : $"{health.Level}: {health.Text}";

    /// <summary>The name by which an autopilot is known.</summary>
    /// <param name="autopilot">As its heartbeat says.</param>
    public static string Autopilot(MavAutopilot autopilot) => autopilot switch
    {
        MavAutopilot.Ardupilotmega => "ArduPilot",
        MavAutopilot.Px4 => "PX4",
        _ => autopilot.ToString(),
    };

    /// <summary>
    /// All directions in which a target may point, and how well that is known: <c>35/215° ±2°</c>.
    /// </summary>
    /// <param name="bearing">Of the target.</param>
    public static string Bearing(in TargetBearing bearing)
    {
        double[] all = bearing.Symmetry switch
        {
            BearingSymmetry.HalfTurn => [0, 180],
            BearingSymmetry.QuarterTurn => [0, 90, 180, 270],
            _ => [0],
        };
        double first = bearing.Angle.Degrees;
        return string.Join("/", all.Select(turn => Number(Math.Round(first + turn) % 360, "0")))
            + $"° ±{Number(Math.Ceiling(bearing.TotalSigma.Degrees), "0")}°";
    }

    /// <summary>", 2 identity switches", to follow the number of false tracks; empty for none.</summary>
    /// <param name="score">The score.</param>
    /// <exception cref="ArgumentNullException">It is null.</exception>
    public static string IdentitySwitches(MissionScore score)
    {
        if (score is null)
            throw new ArgumentNullException(nameof(score));
        return score.IdentitySwitches switch
        {
            0 => string.Empty,
            1 => ", 1 identity switch",
            _ => $", {Number((long)score.IdentitySwitches)} identity switches",
        };
    }

    /// <summary>Among figures: ", 1 rejected by the vehicle that validated it"; empty for none.</summary>
    /// <param name="score">The tracks and the truth.</param>
    /// <exception cref="ArgumentNullException">It is null.</exception>
    public static string RejectedTracks(MissionScore score)
    {
        if (score is null)
            throw new ArgumentNullException(nameof(score));
        return score.RejectedTracks.Count == 0
            ? string.Empty
            : $", {Number((long)score.RejectedTracks.Count)} rejected by the vehicle that validated it";
    }

    /// <summary>
    /// What became of a target, in a word: "found", "rejected" by the operator or the vehicle that validated it, or
    /// "missed".
    /// </summary>
    /// <param name="target">The target.</param>
    internal static string ResultOf(TargetScore target)
        => target.IsFound ? "found" : target.IsRejected ? "rejected" : "missed";

    /// <summary>What became of a target that was not found: "was not found".</summary>
    /// <param name="missed">The target.</param>
    /// <exception cref="ArgumentNullException">It is null.</exception>
    public static string Missed(TargetScore missed)
    {
        if (missed is null)
            throw new ArgumentNullException(nameof(missed));
        return missed.IsRejected ? "was seen, and rejected by " + RejectedBy(missed) : "was not found";
    }

    /// <summary>Who rejected the track of a target, for people.</summary>
    /// <param name="target">With <see cref="TargetScore.IsRejected"/>.</param>
    internal static string RejectedBy(TargetScore target)
        => target.IsRejectedByVehicle ? "the vehicle that validated it" : "the operator";

    /// <summary>The short name of a phase.</summary>
    /// <param name="phase">The phase.</param>
    public static string Phase(MissionPhase phase) => phase switch
    {
        MissionPhase.NoMission => "no mission",
        MissionPhase.WaitingForVehicle => "waiting",
        MissionPhase.Arming => "arming",
        MissionPhase.TakingOff => "take-off",
        MissionPhase.InTransit => "transit",
        MissionPhase.Searching => "searching",
        MissionPhase.Revisiting => "revisit",
        MissionPhase.Holding => "holding",
        MissionPhase.Returning => "returning",
        MissionPhase.Landing => "landing",
        MissionPhase.Done => "done",
        MissionPhase.HandedOver => "handed over",
        MissionPhase.Failed => "failed",
        _ => phase.ToString(),
    };

    // Seven decimals: a centimetre.
    internal static string Degrees(double radians) => Number(Angle.FromRadians(radians).Degrees, "0.0000000");

    // Format characters turn the direction of a line around, or are invisible.
    private static bool IsControl(char c) => char.IsControl(c) || char.GetUnicodeCategory(c) == UnicodeCategory.Format;
}
