namespace Rabit.Uav.Messages;

/// <summary>Which lanes one vehicle of a group flies: a run of them. A plain value.</summary>
/// <param name="SystemId">MAVLink system id of the vehicle.</param>
/// <param name="First">The first of its lanes, from 0.</param>
/// <param name="Count">How many; 0 for a vehicle for which nothing is left.</param>
public readonly record struct LaneShare(byte SystemId, int First, int Count);
