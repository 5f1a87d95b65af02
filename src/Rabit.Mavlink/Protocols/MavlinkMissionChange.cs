using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>A mission, a fence or rally points were uploaded or cleared. A plain value.</summary>
/// <param name="Type">Which of them.</param>
/// <param name="Count">How many items there are now; 0 where it was cleared.</param>
/// <param name="Source">Who did it.</param>
/// <param name="IsSigned">Whether the last frame of it was signed.</param>
/// <param name="OpaqueId">The id of the items, which changes with them; 0 of none.</param>
public readonly record struct MavlinkMissionChange(
    MavMissionType Type, int Count, MavlinkAddress Source, bool IsSigned, uint OpaqueId);
