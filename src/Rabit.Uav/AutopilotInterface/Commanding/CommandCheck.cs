using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>Finds commands that no vehicle could carry out. They are refused before anything is sent.</summary>
internal static class CommandCheck
{
    // More than these is a mistake for what flies on batteries.
    private const double MaxMetres = 5000;
    private const double MaxMetresPerSecond = 60;
    private const double MaxRadiusMetres = 1000;

    /// <summary>What is wrong, by the name of the property; null where nothing is.</summary>
    public static string? FindFault(in VehicleCommand command) => command.Kind switch
    {
        VehicleCommandKind.GoTo =>
            FaultOfPlace(command) ?? FaultOfHeight(command) ?? FaultOfSpeed(command) ?? FaultOfYaw(command)
                ?? FaultOfRadius(command),
        VehicleCommandKind.TakeOff => FaultOfHeight(command),
        VehicleCommandKind.Velocity => FaultOfVelocity(command) ?? FaultOfYaw(command),
        VehicleCommandKind.SetMode => string.IsNullOrEmpty(command.Mode) ? "Mode is empty" : null,
        VehicleCommandKind.PointCamera => FaultOfAngle(nameof(command.CameraPitch), command.CameraPitch, 180)
            ?? FaultOfAngle(nameof(command.CameraYaw), command.CameraYaw, 360),
        VehicleCommandKind.Arm or VehicleCommandKind.Disarm or VehicleCommandKind.Hold or VehicleCommandKind.Return
            or VehicleCommandKind.Land or VehicleCommandKind.TakeControl
            => null,
        _ => FormattableString.Invariant($"Kind is {(int)command.Kind}, which is no command"),
    };

    private static string? FaultOfPlace(in VehicleCommand command)
    {
        if (FaultOfAngle(nameof(command.Latitude), command.Latitude, 90) is { } latitude)
            return latitude;
        if (FaultOfAngle(nameof(command.Longitude), command.Longitude, 180) is { } longitude)
            return longitude;
        return command.Latitude.Radians.Equals(0) && command.Longitude.Radians.Equals(0)
            ? "Latitude and Longitude are both 0, which is no place but an omission"
            : null;
    }

    private static string? FaultOfHeight(in VehicleCommand command)
        => command.HeightAboveHomeMetres is > 0 and <= MaxMetres
            ? null
            : FormattableString.Invariant(
                $"HeightAboveHomeMetres is {command.HeightAboveHomeMetres}; it must be above 0 and at most {MaxMetres}");

    private static string? FaultOfSpeed(in VehicleCommand command)
        => double.IsNaN(command.SpeedMetresPerSecond) || command.SpeedMetresPerSecond is > 0 and <= MaxMetresPerSecond
            ? null
            : FormattableString.Invariant(
                $"SpeedMetresPerSecond is {command.SpeedMetresPerSecond}; it must be above 0 and at most {MaxMetresPerSecond}, or NaN");

    private static string? FaultOfRadius(in VehicleCommand command)
        => command.LoiterRadiusMetres is >= 0 and <= MaxRadiusMetres
            ? null
            : FormattableString.Invariant(
                $"LoiterRadiusMetres is {command.LoiterRadiusMetres}; it must be 0 to {MaxRadiusMetres}");

    private static string? FaultOfYaw(in VehicleCommand command)
        => double.IsNaN(command.Yaw.Radians) ? null : FaultOfAngle(nameof(command.Yaw), command.Yaw, 360);

    private static string? FaultOfVelocity(in VehicleCommand command)
    {
        double north = command.VelocityNed.North;
        double east = command.VelocityNed.East;
        double down = command.VelocityNed.Down;
        double speed = Math.Sqrt((north * north) + (east * east) + (down * down));
        return speed <= MaxMetresPerSecond
            ? null
            : FormattableString.Invariant(
                $"VelocityNed is ({north}, {east}, {down}); it must be at most {MaxMetresPerSecond} m/s");
    }

    private static string? FaultOfAngle(string name, Angle angle, double maxDegrees)
        => Math.Abs(angle.Radians) <= maxDegrees * Angle.RadiansPerDegree
            ? null
            : FormattableString.Invariant($"{name} is {angle}; it must be within {maxDegrees}° of 0");
}
