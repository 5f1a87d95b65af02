using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// What a <see cref="MavlinkMissionServer"/> takes. Anything but <see cref="MavMissionResult.Accepted"/> is sent as the
/// reason, and what was there stays.
/// </summary>
public interface IMavlinkMissionRules
{
    /// <summary>Checks whether someone may upload, clear, or set the current item, at all.</summary>
    /// <param name="type">Mission, fence or rally points; all of them to be cleared.</param>
    /// <param name="count">How many items; 0 clears. The limit of the options was checked before.</param>
    /// <param name="source">Who wants it.</param>
    /// <param name="isSigned">Whether the frame was signed.</param>
    /// <returns>The result.</returns>
    MavMissionResult CheckTransfer(MavMissionType type, int count, MavlinkAddress source, bool isSigned);

    /// <summary>Checks one item, as it arrives.</summary>
    /// <param name="item">The item.</param>
    /// <returns>The result.</returns>
    MavMissionResult CheckItem(in MissionItemInt item);

    /// <summary>Checks all items together, when the last one has arrived.</summary>
    /// <param name="type">Mission, fence or rally points.</param>
    /// <param name="items">The items; use them before it returns.</param>
    /// <returns>The result.</returns>
    MavMissionResult CheckItems(MavMissionType type, ReadOnlySpan<MissionItemInt> items);
}
