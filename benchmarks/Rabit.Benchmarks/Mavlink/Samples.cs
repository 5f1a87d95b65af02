using Rabit.Mavlink.Messages;

namespace Rabit.Benchmarks.Mavlink;

/// <summary>
/// Messages with the values of a vehicle in flight: no trailing zeros to cut but those that are there in life.
/// </summary>
internal static class Samples
{
    public static Heartbeat Heartbeat { get; } = new()
    {
        Type = MavType.Quadrotor,
        Autopilot = MavAutopilot.Ardupilotmega,
        BaseMode = (MavModeFlag)81,
        CustomMode = 4,
        SystemStatus = MavState.Active,
        MavlinkVersion = 3,
    };

    public static Attitude Attitude { get; } = new()
    {
        TimeBootMs = 123_456,
        Roll = 0.1f,
        Pitch = -0.05f,
        Yaw = 1.7f,
        Rollspeed = 0.01f,
        Pitchspeed = 0.02f,
        Yawspeed = -0.03f,
    };

    public static GlobalPositionInt GlobalPositionInt { get; } = new()
    {
        TimeBootMs = 123_456,
        Lat = 473_977_418,
        Lon = 85_455_939,
        Alt = 488_000,
        RelativeAlt = 50_000,
        Vx = 500,
        Vy = -300,
        Vz = 10,
        Hdg = 9_000,
    };
}
