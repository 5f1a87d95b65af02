namespace Rabit.Uav.Messages;

/// <summary>
/// A track of this vehicle that is the target of a <see cref="FollowTask"/>. A target has a new track each time it
/// comes into view after it was lost. A plain value.
/// </summary>
/// <param name="Finder">The finder of the task.</param>
/// <param name="Session">The session of the task.</param>
/// <param name="Number">The number of the task.</param>
/// <param name="TrackId">The track, by its number on this vehicle.</param>
public readonly record struct FollowedTrack(byte Finder, ushort Session, ushort Number, int TrackId);
