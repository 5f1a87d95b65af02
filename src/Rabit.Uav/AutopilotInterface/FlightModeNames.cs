using System.Collections.Generic;
using System.Globalization;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// The flight mode of a heartbeat as a text, by the autopilot's own name. Allocates only for the number of a mode that
/// is not known. One thread.
/// </summary>
public sealed class FlightModeNames
{
    // A working autopilot has a handful of modes unknown here; one that sends noise must not fill the memory.
    private const int MaxRemembered = 64;

    private readonly Dictionary<uint, string> _unknown = [];

    /// <summary>
    /// Returns the name, for example <c>GUIDED</c> or <c>AUTO.LOITER</c>; <c>mode 42</c> where it has none.
    /// </summary>
    /// <param name="heartbeat">Of the autopilot.</param>
    public string NameOf(in Heartbeat heartbeat)
    {
        if ((heartbeat.BaseMode & MavModeFlag.CustomModeEnabled) == 0)
            return GenericName(heartbeat.BaseMode);
        string? name = heartbeat.Autopilot switch
        {
            MavAutopilot.Ardupilotmega => ArdupilotModes.NameOf(heartbeat.Type, heartbeat.CustomMode),
            MavAutopilot.Px4 => Px4Modes.NameOf(heartbeat.CustomMode),
            _ => GenericName(heartbeat.BaseMode),
        };
        return name ?? UnknownName(heartbeat.CustomMode);
    }

    // MAV_MODE_FLAG, from the most autonomous down: each level leaves the flags of those below it set.
    private static string GenericName(MavModeFlag flags) => flags switch
    {
        _ when Has(flags, MavModeFlag.TestEnabled) => "TEST",
        _ when Has(flags, MavModeFlag.AutoEnabled) => "AUTO",
        _ when Has(flags, MavModeFlag.GuidedEnabled) => "GUIDED",
        _ when Has(flags, MavModeFlag.StabilizeEnabled) => "STABILIZE",
        _ when Has(flags, MavModeFlag.ManualInputEnabled) => "MANUAL",
        _ => "PREFLIGHT",
    };

    private static bool Has(MavModeFlag flags, MavModeFlag flag) => (flags & flag) != 0;

    private string UnknownName(uint customMode)
    {
        if (_unknown.TryGetValue(customMode, out string? name))
            return name;
        if (_unknown.Count == MaxRemembered)
            _unknown.Clear();
        name = "mode " + customMode.ToString(CultureInfo.InvariantCulture);
        _unknown.Add(customMode, name);
        return name;
    }
}
