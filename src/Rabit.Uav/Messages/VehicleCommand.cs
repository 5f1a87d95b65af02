using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.Messages;

/// <summary>
/// A command of Mission Control to the vehicle. Autopilot Interface converts it to the autopilot's form, executes it
/// and reports a <see cref="VehicleCommandResult"/> of the same id. A newer command replaces one that is still being
/// executed. A plain value.
/// </summary>
public struct VehicleCommand
{
    /// <summary>
    /// Chosen by the sender, above that of every earlier one; the result carries it. A command with the id of the
    /// newest one is a renewal: nothing is sent again, only its <see cref="Validity"/> begins again.
    /// </summary>
    public long Id { get; set; }

    /// <summary>
    /// How long the command stands without a renewal, counted from when Autopilot Interface receives it; zero: without
    /// limit. When it has passed in flight, while we command and neither return nor landing runs, Autopilot Interface
    /// returns to launch by itself: the commander no longer runs.
    /// </summary>
    public TimeSpan Validity { get; set; }

    /// <summary>What to do; says which of the other properties are read.</summary>
    public VehicleCommandKind Kind { get; set; }

    /// <summary>Latitude of the position, north positive. Of <see cref="VehicleCommandKind.GoTo"/>.</summary>
    public Angle Latitude { get; set; }

    /// <summary>Longitude of the position, east positive. Of <see cref="VehicleCommandKind.GoTo"/>.</summary>
    public Angle Longitude { get; set; }

    /// <summary>
    /// Height above home, metres, up positive. Of <see cref="VehicleCommandKind.GoTo"/> and
    /// <see cref="VehicleCommandKind.TakeOff"/>.
    /// </summary>
    public double HeightAboveHomeMetres { get; set; }

    /// <summary>
    /// Ground speed to the position, metres per second; NaN leaves it to the autopilot. Of
    /// <see cref="VehicleCommandKind.GoTo"/>.
    /// </summary>
    public double SpeedMetresPerSecond { get; set; }

    /// <summary>
    /// Radius of the circle, clockwise, that a fixed wing flies about the position, metres, up to 1000; 0 leaves it to
    /// the autopilot. Of <see cref="VehicleCommandKind.GoTo"/>; a multirotor does not read it.
    /// </summary>
    public double LoiterRadiusMetres { get; set; }

    /// <summary>
    /// Heading to keep, clockwise from true north; <see cref="Angle.NaN"/> leaves it to the autopilot. Of GoTo and
    /// Velocity.
    /// </summary>
    public Angle Yaw { get; set; }

    /// <summary>
    /// Velocity over ground, metres per second, north-east-down. Of <see cref="VehicleCommandKind.Velocity"/>; it is to
    /// be repeated at 1 Hz or more.
    /// </summary>
    public NedVector VelocityNed { get; set; }

    /// <summary>Flight mode by the autopilot's own name. Of <see cref="VehicleCommandKind.SetMode"/>.</summary>
    public string? Mode { get; set; }

    /// <summary>
    /// Camera pitch in <see cref="GimbalFrame"/>, up positive; -90 degrees points straight down. Of
    /// <see cref="VehicleCommandKind.PointCamera"/>.
    /// </summary>
    public Angle CameraPitch { get; set; }

    /// <summary>
    /// Camera yaw in <see cref="GimbalFrame"/>, right positive. Of <see cref="VehicleCommandKind.PointCamera"/>.
    /// </summary>
    public Angle CameraYaw { get; set; }

    /// <summary>
    /// What the angles of the camera are against: the gimbal is to hold them so. Of
    /// <see cref="VehicleCommandKind.PointCamera"/>.
    /// </summary>
    public GimbalFrame GimbalFrame { get; set; }
}
