namespace Rabit.Uav.Messages;

/// <summary>The phase of a mission.</summary>
public enum MissionPhase
{
    /// <summary>There is no mission to fly: we observe.</summary>
    NoMission,

    /// <summary>Until the vehicle is connected, healthy and has a position.</summary>
    WaitingForVehicle,

    /// <summary>Arming.</summary>
    Arming,

    /// <summary>Taking off and climbing to the height of the search.</summary>
    TakingOff,

    /// <summary>On the way to the area.</summary>
    InTransit,

    /// <summary>Flying the lanes.</summary>
    Searching,

    /// <summary>Off the lanes, revisiting a confirmed target.</summary>
    Revisiting,

    /// <summary>
    /// Holding the position: at the operator's command until the next one, or because the vehicle made no progress.
    /// </summary>
    Holding,

    /// <summary>Return to launch.</summary>
    Returning,

    /// <summary>Landing.</summary>
    Landing,

    /// <summary>Landed, motors off.</summary>
    Done,

    /// <summary>
    /// The pilot, the autopilot's failsafe or another commander took over, or the vehicle was flying already at the
    /// start: nothing is commanded until the operator gives control back. Over once the motors are off.
    /// </summary>
    HandedOver,

    /// <summary>
    /// The mission could not be flown; <see cref="MissionStatus.Text"/> says why. Nothing more is commanded.
    /// </summary>
    Failed,
}
