using System;

namespace Rabit.Mavlink;

/// <summary>A command that was received. A plain value.</summary>
/// <param name="Handle">Identifies it for <see cref="MavlinkCommandServer.Complete"/>; above 0.</param>
/// <param name="Source">Who sent it.</param>
/// <param name="IsSigned">Whether its frame was signed; the reader's verifier has checked the signature.</param>
/// <param name="Command">
/// The command; its target is who it was sent to. From COMMAND_INT (<see cref="MavlinkCommandForms.IntOnly"/>) it has
/// the location with its frame, and the same integers as parameters 5 and 6; from COMMAND_LONG
/// (<see cref="MavlinkCommandForms.LongOnly"/>) the parameters 5 to 7, of a location in degrees.
/// </param>
/// <param name="ReceivedAt">When its first copy was received.</param>
public readonly record struct MavlinkCommandRequest(
    int Handle, MavlinkAddress Source, bool IsSigned, MavlinkCommand Command, TimeSpan ReceivedAt);
