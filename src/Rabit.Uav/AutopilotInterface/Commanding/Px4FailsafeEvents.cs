namespace Rabit.Uav.AutopilotInterface;

/// <summary>The events (EVENT, message 410) by which PX4 says that a failsafe acts, not only warns.</summary>
/// <remarks>
/// An id is a hash of the name in PX4's source and stays the same from version to version. Ids and names are of PX4
/// 1.14, taken from the metadata of the build that the recordings in tests/data/autopilots were made with.
/// </remarks>
internal static class Px4FailsafeEvents
{
    /// <summary>The name of an event; null where it is none of a failsafe that acts.</summary>
    public static string? NameOf(uint id) => id switch
    {
        26528394 => "commander_failsafe_enter",
        31382480 => "commander_failsafe_enter_generic",
        21279712 => "commander_failsafe_enter_generic_hold",
        30481910 => "commander_failsafe_enter_hold",
        _ => null,
    };
}
