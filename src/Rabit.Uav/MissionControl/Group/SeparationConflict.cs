namespace Rabit.Uav.MissionControl;

/// <summary>A vehicle of the group that is too near, or will be. A plain value.</summary>
/// <param name="SystemId">Its MAVLink system id.</param>
/// <param name="Place">Where it is then.</param>
/// <param name="AboveMetres">How far it is above us then; below zero: below us.</param>
/// <param name="SecondsToGo">In what time.</param>
internal readonly record struct SeparationConflict(
    byte SystemId, PlanePoint Place, double AboveMetres, double SecondsToGo);
