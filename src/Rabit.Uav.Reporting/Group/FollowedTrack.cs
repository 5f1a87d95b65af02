namespace Rabit.Uav.Reporting;

/// <summary>A track of a vehicle that is the target of a <see cref="Messages.FollowTask"/>. A plain value.</summary>
/// <param name="Finder">The finder of the task.</param>
/// <param name="Session">The session of the task.</param>
/// <param name="Number">The number of the task.</param>
/// <param name="TrackId">The track, by its number on the vehicle that recorded this.</param>
public readonly record struct FollowedTrack(byte Finder, ushort Session, ushort Number, int TrackId);
