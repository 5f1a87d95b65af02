namespace Rabit.Uav.Messages;

/// <summary>What became of the vehicle when the program was stopped while Mission Control commanded it.</summary>
public enum MissionStopResult
{
    /// <summary>
    /// Nothing was to be done: no stop, the vehicle is on the ground, it returns or lands already, or we do not command
    /// it.
    /// </summary>
    None,

    /// <summary>The stop waits for the answer to the last command.</summary>
    InProgress,

    /// <summary>The vehicle holds its position: the autopilot accepted the command.</summary>
    Held,

    /// <summary>The vehicle returns to launch: the autopilot accepted the command.</summary>
    Returning,

    /// <summary>The vehicle is in the air, and whether it holds or returns is not known.</summary>
    NotVerified,
}
