namespace Rabit.Uav.Messages;

/// <summary>
/// What the operator can command. In which phase which of them is refused: docs/managers/mission-control.md.
/// </summary>
public enum OperatorCommand
{
    /// <summary>Hold the position until the next command.</summary>
    Hold,

    /// <summary>Return to launch (RTL) and land there: the mission is given up.</summary>
    Return,

    /// <summary>
    /// Continue the mission where it was interrupted by a hold, a return at the operator's command followed by a hold,
    /// or a takeover.
    /// </summary>
    Continue,

    /// <summary>Land at the present position: the mission is given up.</summary>
    Land,

    /// <summary>Leave out what remains of the lane, or the next lane where none is being flown.</summary>
    SkipLane,

    /// <summary>Revisit a target now, and continue the search after that.</summary>
    Revisit,

    /// <summary>Fly over a place now, and continue the search after that.</summary>
    RevisitPlace,

    /// <summary>A target is what it seems to be: it stays confirmed, whatever the camera says.</summary>
    Confirm,

    /// <summary>A target is none: it is neither revisited nor reported as confirmed.</summary>
    Reject,

    /// <summary>Fly at another speed from now on.</summary>
    ChangeSpeed,

    /// <summary>Set a value of the mission, from the next leg on.</summary>
    ChangeParameter,

    /// <summary>
    /// Offer another area, with its keep-outs: the next <see cref="Continue"/>, in whatever phase, takes it over.
    /// Without corners: withdraw what was offered.
    /// </summary>
    OfferArea,
}
