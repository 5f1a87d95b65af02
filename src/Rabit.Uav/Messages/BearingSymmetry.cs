namespace Rabit.Uav.Messages;

/// <summary>By which turns a target looks the same, so that its bearing is known up to them only.</summary>
public enum BearingSymmetry
{
    /// <summary>By none: its front is known, as the upper edge of a marker.</summary>
    None,

    /// <summary>By half a turn: it is longer than wide, and which end is the front is not known.</summary>
    HalfTurn,

    /// <summary>By a quarter of a turn: it is a square, and the bearing is that of any of its sides.</summary>
    QuarterTurn,
}
