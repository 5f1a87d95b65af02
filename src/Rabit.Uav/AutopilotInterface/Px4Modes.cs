using System;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Flight modes of PX4 by the names of its own commander. The custom mode of a heartbeat holds a main mode in its third
/// byte and a sub mode in its fourth (PX4, px4_custom_mode.h); MAVLink's definitions do not list them.
/// </summary>
internal static class Px4Modes
{
    public const uint Takeoff = 0x0204_0000;
    public const uint Offboard = 0x0006_0000;
    public const uint Loiter = 0x0304_0000;
    public const uint Return = 0x0504_0000;
    public const uint Land = 0x0604_0000;

    private const int PositionControl = 3;
    private const int Auto = 4;
    private const uint MaxMainMode = 11;
    private const uint MaxSubMode = 18;

    /// <summary>The number of a mode, by its name in any case; null where there is none of that name.</summary>
    public static uint? NumberOf(string name)
    {
        for (uint main = 1; main <= MaxMainMode; main++)
        {
            for (uint sub = 0; sub <= MaxSubMode; sub++)
            {
                uint mode = (main << 16) | (sub << 24);
                if (string.Equals(NameOf(mode), name, StringComparison.OrdinalIgnoreCase))
                    return mode;
            }
        }

        return null;
    }

    /// <summary>The name; null for a number that is not known here.</summary>
    public static string? NameOf(uint customMode)
    {
        var main = (byte)(customMode >> 16);
        var sub = (byte)(customMode >> 24);
        return main switch
        {
            PositionControl => PositionControlName(sub),
            Auto => AutoName(sub),
            _ => MainName(main),
        };
    }

    private static string? MainName(byte main) => main switch
    {
        1 => "MANUAL",
        2 => "ALTCTL",
        5 => "ACRO",
        6 => "OFFBOARD",
        7 => "STABILIZED",
        8 => "RATTITUDE",
        9 => "SIMPLE",
        10 => "TERMINATION",
        11 => "ALTITUDE_CRUISE",
        _ => null,
    };

    private static string? PositionControlName(byte sub) => sub switch
    {
        0 => "POSCTL",
        1 => "POSCTL.ORBIT",
        2 => "POSCTL.SLOW",
        _ => null,
    };

    private static string? AutoName(byte sub) => sub switch
    {
        1 => "AUTO.READY",
        2 => "AUTO.TAKEOFF",
        3 => "AUTO.LOITER",
        4 => "AUTO.MISSION",
        5 => "AUTO.RTL",
        6 => "AUTO.LAND",
        7 => "AUTO.RTGS",
        8 => "AUTO.FOLLOW_TARGET",
        9 => "AUTO.PRECLAND",
        10 => "AUTO.VTOL_TAKEOFF",
        11 => "AUTO.EXTERNAL1",
        12 => "AUTO.EXTERNAL2",
        13 => "AUTO.EXTERNAL3",
        14 => "AUTO.EXTERNAL4",
        15 => "AUTO.EXTERNAL5",
        16 => "AUTO.EXTERNAL6",
        17 => "AUTO.EXTERNAL7",
        18 => "AUTO.EXTERNAL8",
        _ => null,
    };
}
