namespace Rabit.Mavlink;

/// <summary>A request to cancel a command that is at work. A plain value.</summary>
/// <param name="Handle">Of the command.</param>
/// <param name="Source">Who wants it cancelled: not always who sent the command.</param>
/// <param name="IsSigned">Whether the frame was signed.</param>
public readonly record struct MavlinkCommandCancellation(int Handle, MavlinkAddress Source, bool IsSigned);
