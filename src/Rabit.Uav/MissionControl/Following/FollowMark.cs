using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Where a target that moves was at a time. Immutable.</summary>
/// <param name="Place">In the frame of the plan.</param>
/// <param name="Velocity">Metres per second.</param>
/// <param name="Time">By the clock of the run.</param>
internal readonly record struct FollowMark(PlanePoint Place, PlanePoint Velocity, TimeSpan Time)
{
    public static FollowMark Of(TargetTrack track, MissionFlight flight) => new(
        Revisits.PositionOf(track, flight), new PlanePoint(track.VelocityNed.North, track.VelocityNed.East),
        track.Time);

    public static FollowMark Of(in FollowTask task, LocalNedFrame frame) => new(
        ValidationLook.PlaceOf(frame, task.Position), new PlanePoint(task.VelocityNed.North, task.VelocityNed.East),
        task.Time);

    /// <summary>Where it is, if it went straight on.</summary>
    /// <param name="now">The time.</param>
    /// <param name="maxSeconds">It is not taken to go on for longer.</param>
    public PlanePoint PlaceAt(TimeSpan now, double maxSeconds)
        => Place + (Math.Min(maxSeconds, Math.Max(0, (now - Time).ExactSeconds)) * Velocity);
}
