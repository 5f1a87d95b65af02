namespace Rabit.Uav.CameraGeometry;

/// <summary>What the angles of a gimbal are against.</summary>
public enum GimbalFrame
{
    /// <summary>The body of the vehicle: a gimbal that does not stabilise, and rolls and pitches with it.</summary>
    Body,

    /// <summary>
    /// The horizon, and the vehicle's heading: a stabilised gimbal that follows the heading (MAVLink: roll and pitch
    /// locked, yaw in the vehicle frame).
    /// </summary>
    Heading,

    /// <summary>The horizon and true north (MAVLink: yaw in the earth frame; DJI's metadata).</summary>
    North,
}
