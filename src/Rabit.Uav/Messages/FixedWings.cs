using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Messages;

/// <summary>Which vehicles are fixed wings, and the mode in which a pilot gives one over.</summary>
internal static class FixedWings
{
    // PX4's custom mode: main mode AUTO, sub mode LOITER.
    private const uint Px4Loiter = 0x0304_0000;

    /// <summary>Whether it flies as an aeroplane does, and never as a copter.</summary>
    public static bool IsFixedWing(MavType vehicle) => vehicle == MavType.FixedWing;

    /// <summary>The custom mode in which it takes places from us, and its name; null where the make has none.</summary>
    public static (uint Mode, string Name)? GivenMode(MavAutopilot autopilot) => autopilot switch
    {
        MavAutopilot.Ardupilotmega => ((uint)PlaneMode.Guided, "GUIDED"),
        MavAutopilot.Px4 => (Px4Loiter, "AUTO.LOITER"),
        _ => null,
    };
}
