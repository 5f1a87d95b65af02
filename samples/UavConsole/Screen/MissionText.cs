using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;

namespace UavConsole;

/// <summary>What an operator looks for in flight, in a few words each; a dash where it is not known.</summary>
internal static class MissionText
{
    private const string Unknown = "-";
    private const int UnknownSatellites = 255;

    /// <summary>What is being done, without the name of the phase, which stands above it.</summary>
    public static string Doing(in MissionStatus mission)
    {
        string text = mission.Text ?? string.Empty;
        string phase = FlightText.Phase(mission.Phase) + ": ";
        return text.StartsWith(phase, StringComparison.Ordinal) ? text.Substring(phase.Length) : text;
    }

    /// <summary>What follows when nothing comes between.</summary>
    public static string Next(in MissionStatus mission)
    {
        int lanes = (mission.Plan?.Lanes.Length ?? 0) / 2;
        string lane = mission.LanesFlown < lanes
            ? $"lane {FlightText.Number(mission.LanesFlown + 1)} of {FlightText.Number(lanes)}"
            : "the way home";
        return mission.Phase switch
        {
            MissionPhase.WaitingForVehicle => "arming",
            MissionPhase.Arming => "take-off",
            MissionPhase.TakingOff or MissionPhase.InTransit or MissionPhase.Revisiting => lane,
            MissionPhase.Searching => mission.LanesFlown + 1 < lanes
                ? $"lane {FlightText.Number(mission.LanesFlown + 2)} of {FlightText.Number(lanes)}"
                : "the way home",
            MissionPhase.Holding => "the operator's command",
            MissionPhase.Returning => "landing at home",
            MissionPhase.Landing => "motors off",
            _ => Unknown,
        };
    }

    /// <summary>For a narrow panel: what is left, what home takes, and how long until it has to return.</summary>
    public static string ShortEnergy(in EnergyStatus energy) => !energy.IsKnown ? Unknown : string.Format(
        CultureInfo.InvariantCulture, "{0:0}%, home {1:0}%, {2}", energy.ChargeLeft * 100, energy.ChargeHome * 100,
        energy.MustReturn ? "has to return" : FlightText.Clock(energy.TimeToReturn) + " left");

    /// <summary>How far home is and in which direction, seen from the vehicle.</summary>
    public static string Home(in VehicleState vehicle, SearchPlan? plan)
    {
        if (plan is null || vehicle.PositionTime is null)
            return Unknown;
        NedPosition home = LocalNedFrame.IgnoringGeoid(vehicle.Position).ToNed(plan.Home);
        double metres = Math.Sqrt((home.North * home.North) + (home.East * home.East));
        return metres < 1e7
            ? $"{FlightText.Number(metres, "0")} m away at {Bearing(home.North, home.East)}"
            : Unknown;
    }

    /// <summary>Its speed, and where it comes from.</summary>
    public static string Wind(in VehicleState vehicle)
        => vehicle.WindTime is null || double.IsNaN(vehicle.WindMetresPerSecond)
            ? "not known"
            : $"{FlightText.Number(vehicle.WindMetresPerSecond, "0.0")} m/s from "
                + Bearing(-vehicle.WindVelocityNed.North, -vehicle.WindVelocityNed.East);

    public static string Satellites(in VehicleState vehicle)
        => vehicle.GpsTime is null || vehicle.Satellites == UnknownSatellites
            ? "? sats"
            : FlightText.Number(vehicle.Satellites) + " sats";

    /// <summary>How much of what was sent to us came in, and which links do not receive.</summary>
    public static string Links(IReadOnlyList<LinkStatus> links)
    {
        long received = links.Sum(l => l.FramesIn);
        long missing = links.Sum(l => l.FramesMissing);
        if (received == 0)
            return links.Count == 0 ? Unknown : "nothing received";
        string share = FlightText.Number(100.0 * received / (received + missing), "0.0") + " % received";
        string[] others =
        [
            .. links.Select((l, index) => (l.State, index)).Where(l => l.State != LinkState.Receiving)
                .Select(l => $"link {FlightText.Number(l.index)} {l.State.ToString().ToLowerInvariant()}"),
        ];
        return string.Join(", ", others.Append(share));
    }

    /// <summary>How many of the last pictures are usable.</summary>
    public static string Camera(in ImagingStatus imaging)
    {
        if (!imaging.HasCamera)
            return "none";
        if (imaging.Fault is { } fault)
            return fault;
        string pictures = $"{FlightText.Number(imaging.Pictures.Of(PictureQuality.Usable))} pictures";
        return imaging.UsableShare is not { } share
            ? pictures + ", no search now"
            : $"{FlightText.Number(share * 100, "0")} % usable, {pictures}";
    }

    /// <summary>What the last picture was like; null before the first.</summary>
    /// <param name="imaging">With the last picture.</param>
    /// <param name="isShort">Without its levels, for a narrow screen.</param>
    public static string? LastPicture(in ImagingStatus imaging, bool isShort = false)
    {
        if (imaging.LastPicture is not { } picture)
            return null;
        string exposure = picture.Exposure > TimeSpan.Zero
            ? $", {FlightText.Number(picture.Exposure.TotalMilliseconds, "0.##")} ms"
            : string.Empty;
        if (isShort)
        {
            return $"{FlightText.Number(picture.Detections)} found, sharp "
                + $"{FlightText.Number(picture.Sharpness, "0.00")}{exposure}";
        }

        string clipped = picture.ClippedShare >= 0.005
            ? $", {FlightText.Number(picture.ClippedShare * 100, "0")} % clipped"
            : string.Empty;
        string sharpness = double.IsNaN(picture.Sharpness)
            ? "no detail"
            : $"sharpness {FlightText.Number(picture.Sharpness, "0.00")}";
        return $"{FlightText.Number(picture.Detections)} detected, {sharpness}{exposure}{clipped}, levels "
            + $"{FlightText.Number(picture.DarkLevel)} to {FlightText.Number(picture.BrightLevel)}";
    }

    private static string Bearing(double north, double east)
    {
        double degrees = Math.Atan2(east, north) * 180 / Math.PI;
        return FlightText.Number(Math.Round(degrees < 0 ? degrees + 360 : degrees) % 360, "000") + "°";
    }
}
