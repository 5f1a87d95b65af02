namespace Rabit.Uav.Messages;

/// <summary>
/// What became of the failsafe parameters and the fence that the autopilot was to be given before the flight.
/// </summary>
public enum AutopilotSetupState
{
    /// <summary>Nothing is to be written.</summary>
    None,

    /// <summary>Being written, or waiting until it can be.</summary>
    Writing,

    /// <summary>The autopilot has confirmed all of it; its own values are kept on disk.</summary>
    Done,

    /// <summary>Not all of it is as it was to be; <see cref="AutopilotParameters.SetupText"/> says what.</summary>
    Failed,

    /// <summary>The autopilot's own values are being written back.</summary>
    Restoring,

    /// <summary>The autopilot has its own values again.</summary>
    Restored,
}
