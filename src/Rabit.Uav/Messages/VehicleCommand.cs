using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>
/// What Mission Control wants the vehicle to do; Autopilot Interface puts it into the autopilot's form, sees it through and answers
/// with a <see cref="VehicleCommandResult"/> of the same id. A newer command replaces the one that is still being worked at. A plain value.
/// </summary>
public struct VehicleCommand
{
    /// <summary>Chosen by the sender, above that of every earlier one; the answer carries it.</summary>
    public long Id { get; set; }

    /// <summary>What to do; says which of the other properties are read.</summary>
    public VehicleCommandKind Kind { get; set; }

    /// <summary>Latitude to go to, radians, north positive. Of <see cref="VehicleCommandKind.GoTo"/>.</summary>
    public double LatitudeRadians { get; set; }

    /// <summary>Longitude to go to, radians, east positive. Of <see cref="VehicleCommandKind.GoTo"/>.</summary>
    public double LongitudeRadians { get; set; }

    /// <summary>Height above home, metres, up positive. Of <see cref="VehicleCommandKind.GoTo"/> and <see cref="VehicleCommandKind.TakeOff"/>.</summary>
    public double HeightAboveHomeMetres { get; set; }

    /// <summary>Ground speed on the way, metres per second; NaN leaves it to the autopilot. Of <see cref="VehicleCommandKind.GoTo"/>.</summary>
    public double SpeedMetresPerSecond { get; set; }

    /// <summary>Heading to keep, radians clockwise from true north; NaN leaves it to the autopilot. Of GoTo and Velocity.</summary>
    public double YawRadians { get; set; }

    /// <summary>Velocity over ground to fly, metres per second, north-east-down. Of <see cref="VehicleCommandKind.Velocity"/>; it is to be repeated at 1 Hz or more.</summary>
    public NedVector VelocityNed { get; set; }

    /// <summary>Flight mode by the autopilot's own name. Of <see cref="VehicleCommandKind.SetMode"/>.</summary>
    public string? Mode { get; set; }

    /// <summary>Camera pitch against the body, radians, up positive; -pi/2 looks straight down. Of <see cref="VehicleCommandKind.PointCamera"/>.</summary>
    public double CameraPitchRadians { get; set; }

    /// <summary>Camera yaw against the body, radians, right positive. Of <see cref="VehicleCommandKind.PointCamera"/>.</summary>
    public double CameraYawRadians { get; set; }
}
