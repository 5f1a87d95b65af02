using System;

namespace Rabit.Mavlink;

/// <summary>How a transfer of files ended. A plain value.</summary>
/// <param name="Status">Whether it was done, or why not.</param>
/// <param name="Error">
/// The reason of a refusal as the protocol numbers it (MAVLink guide, "File Transfer Protocol"); 0 without one.
/// </param>
/// <param name="IsChecked">Whether the component computed a checksum of the file, and it is right.</param>
/// <param name="Sent">How many requests were sent.</param>
/// <param name="EndedAt">When it ended.</param>
public readonly record struct MavlinkFtpOutcome(
    MavlinkFtpStatus Status, int Error, bool IsChecked, int Sent, TimeSpan EndedAt);
