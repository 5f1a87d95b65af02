using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.GroundControl;

/// <summary>AUTOPILOT_VERSION of our component: what it serves, and the version of this library.</summary>
internal static class OwnVersion
{
    private const MavProtocolCapability Served =
        MavProtocolCapability.ParamEncodeBytewise | MavProtocolCapability.CommandInt | MavProtocolCapability.MissionInt
        | MavProtocolCapability.MissionFence | MavProtocolCapability.Mavlink2;

    /// <summary>Whether a command asks for it.</summary>
    public static bool IsWanted(MavCmd command, float parameter1)
        => (command == MavCmd.RequestMessage && parameter1.Equals(AutopilotVersion.MavlinkId))
            || (command == MavCmd.RequestAutopilotCapabilities && parameter1.Equals(1));

    public static AutopilotVersion Create(bool servesFiles)
    {
        Version version = typeof(OwnVersion).Assembly.GetName().Version ?? new Version(0, 0);
        return new AutopilotVersion
        {
            Capabilities = servesFiles ? Served | MavProtocolCapability.Ftp : Served,
            FlightSwVersion = Packed(version),
        };
    }

    // Major, minor and patch in a byte each; the last byte is the type: 0 is one under development.
    private static uint Packed(Version version)
        => ((uint)(byte)version.Major << 24) | ((uint)(byte)version.Minor << 16)
            | ((uint)(byte)Math.Max(0, version.Build) << 8);
}
