using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>Flight modes of ArduCopter that the simulation knows, and what is true of them.</summary>
internal static class CopterModes
{
    private static readonly CopterMode[] Known =
        [CopterMode.Stabilize, CopterMode.AltHold, CopterMode.Auto, CopterMode.Guided, CopterMode.Loiter,
            CopterMode.Rtl, CopterMode.Land, CopterMode.Poshold, CopterMode.Brake];

    public static IReadOnlyList<CopterMode> All => Known;

    /// <summary>The mode that means the same for all autopilots.</summary>
    public static MavStandardMode StandardOf(CopterMode mode) => mode switch
    {
        CopterMode.AltHold => MavStandardMode.AltitudeHold,
        CopterMode.Loiter => MavStandardMode.PositionHold,
        CopterMode.Auto => MavStandardMode.Mission,
        CopterMode.Rtl => MavStandardMode.SafeRecovery,
        CopterMode.Land => MavStandardMode.Land,
        _ => MavStandardMode.NonStandard,
    };

    public static bool IsKnown(uint number) => Array.IndexOf(Known, (CopterMode)number) >= 0;

    /// <summary>By the name that the autopilot's texts have, in any case.</summary>
    public static bool TryFind(string name, out CopterMode mode)
    {
        foreach (CopterMode candidate in Known)
        {
            if (!string.Equals(name, NameOf(candidate), StringComparison.OrdinalIgnoreCase))
                continue;
            mode = candidate;
            return true;
        }

        mode = default;
        return false;
    }

    public static bool NeedsPosition(CopterMode mode)
        => mode is not (CopterMode.Stabilize or CopterMode.AltHold or CopterMode.Land);

    /// <summary>Whether the pilot's sticks fly it, so that it goes on without a ground station.</summary>
    public static bool IsFlownByPilot(CopterMode mode)
        => mode is CopterMode.Stabilize or CopterMode.AltHold or CopterMode.Loiter or CopterMode.Poshold
            or CopterMode.Brake;

    /// <summary>Whether a ground station may arm in it.</summary>
    public static bool IsArmable(CopterMode mode)
        => mode is CopterMode.Stabilize or CopterMode.AltHold or CopterMode.Loiter or CopterMode.Poshold
            or CopterMode.Guided;

    /// <summary>
    /// Whether the heartbeat sets MAV_MODE_FLAG_GUIDED_ENABLED: in GUIDED always, in others that steer by position
    /// while armed.
    /// </summary>
    public static bool IsGuidedFlag(CopterMode mode, bool isArmed) => mode == CopterMode.Guided
        || (isArmed
            && mode is (CopterMode.Auto or CopterMode.Loiter or CopterMode.Rtl or CopterMode.Poshold
                or CopterMode.Brake));

    /// <summary>As the autopilot's texts have it.</summary>
    public static string NameOf(CopterMode mode) => mode switch
    {
        CopterMode.AltHold => "ALT_HOLD",
        CopterMode.Rtl => "RTL",
        _ => mode.ToString().ToUpperInvariant(),
    };
}
