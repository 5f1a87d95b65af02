namespace Rabit.Uav.Simulation;

/// <summary>What can be made to go wrong.</summary>
public enum ScriptedFaultKind
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>The vehicle neither receives nor sends for the duration; it flies on.</summary>
    LinkSilent,

    /// <summary>The battery is suddenly as empty as the value says: what is left, 0 to 1.</summary>
    BatteryTo,

    /// <summary>The camera gives no pictures for the duration.</summary>
    CameraFreeze,

    /// <summary>
    /// The mean wind becomes the value, m/s, within a few seconds; after the duration what it was, or never where
    /// that is zero.
    /// </summary>
    WindTo,

    /// <summary>
    /// The pilot takes the flight mode with the number of the value, by the switch on the remote control.
    /// </summary>
    PilotMode,

    /// <summary>
    /// A unit of work of a manager on board takes the duration: the first one that begins at the time or later. For
    /// <see cref="SimulatedWorld.AddHangsTo"/>.
    /// </summary>
    ManagerHangs,
}
