namespace Rabit.Uav.AutopilotInterface;

/// <summary>How far the command that is worked at is.</summary>
internal enum ExecutorPhase
{
    /// <summary>There is none.</summary>
    Idle,

    /// <summary>Until the autopilot is known.</summary>
    Planning,

    /// <summary>
    /// A step is sent, once nothing earlier can be answered any more and, where it needs one, a report has shown our
    /// mode, until it is acknowledged.
    /// </summary>
    Sending,

    /// <summary>It was accepted, until a report shows the mode.</summary>
    AwaitingMode,

    /// <summary>It was refused, until a text says why.</summary>
    AwaitingReason,

    /// <summary>Until the velocities can be sent.</summary>
    StartingVelocity,

    /// <summary>The stream of set-points runs, until OFFBOARD can be asked for.</summary>
    StartingStream,

    /// <summary>The operator gave us the command, until a report says in what mode the vehicle is.</summary>
    TakingControl,
}
