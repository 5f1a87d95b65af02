using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>What is true of PX4's flight modes.</summary>
internal static class Px4ModeNames
{
    private const byte MainManual = 1;
    private const byte MainAcro = 5;
    private const byte MainStabilized = 7;

    private static readonly Px4Mode[] Flown =
    [
        Px4Mode.Altctl, Px4Mode.Posctl, Px4Mode.Orbit, Px4Mode.Offboard, Px4Mode.Takeoff, Px4Mode.Loiter,
        Px4Mode.Mission, Px4Mode.Rtl, Px4Mode.Land,
    ];

    public static bool IsFlown(uint customMode)
        => Array.IndexOf(Flown, (Px4Mode)customMode) >= 0;

    /// <summary>The number of a mode by its name, in any case.</summary>
    public static bool TryFind(string name, out uint customMode)
    {
        foreach (Px4Mode mode in Flown)
        {
            customMode = (uint)mode;
            if (string.Equals(name, NameOf(mode), StringComparison.OrdinalIgnoreCase))
                return true;
        }

        customMode = 0;
        return false;
    }

    /// <summary>Modes of PX4 that the simulation does not fly: manual ones.</summary>
    public static bool IsKnownButNotFlown(uint customMode)
        => (byte)(customMode >> 16) is MainManual or MainAcro or MainStabilized;

    public static bool IsAuto(Px4Mode mode)
        => mode is Px4Mode.Takeoff or Px4Mode.Loiter or Px4Mode.Mission or Px4Mode.Rtl or Px4Mode.Land;

    public static bool NeedsPosition(Px4Mode mode) => mode is not (Px4Mode.Altctl or Px4Mode.Land);

    /// <summary>Modes that nothing is armed in; they are left again when it disarms.</summary>
    public static bool PreventsArming(Px4Mode mode) => mode is Px4Mode.Rtl or Px4Mode.Land;

    /// <summary>As the recorded heartbeats have it: 157 in AUTO, 145 in OFFBOARD, 209 in POSCTL when armed.</summary>
    public static MavModeFlag BaseMode(Px4Mode mode, bool isArmed)
    {
        MavModeFlag flags = MavModeFlag.CustomModeEnabled | MavModeFlag.StabilizeEnabled;
        if (IsAuto(mode))
            flags |= MavModeFlag.AutoEnabled | MavModeFlag.GuidedEnabled;
        else if (mode is Px4Mode.Altctl or Px4Mode.Posctl)
            flags |= MavModeFlag.ManualInputEnabled;
        return isArmed ? flags | MavModeFlag.SafetyArmed : flags;
    }

    /// <summary>As Px4's tools name it.</summary>
    public static string NameOf(Px4Mode mode) => mode switch
    {
        Px4Mode.Altctl => "ALTCTL",
        Px4Mode.Posctl => "POSCTL",
        Px4Mode.Orbit => "POSCTL.ORBIT",
        Px4Mode.Offboard => "OFFBOARD",
        Px4Mode.Takeoff => "AUTO.TAKEOFF",
        Px4Mode.Loiter => "AUTO.LOITER",
        Px4Mode.Mission => "AUTO.MISSION",
        Px4Mode.Rtl => "AUTO.RTL",
        _ => "AUTO.LAND",
    };
}
