using System;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// How fast a target turns, from how the direction of its track's velocity changes, and where it is then if it goes on
/// at that speed and turn. One thread.
/// </summary>
internal sealed class TargetTurn
{
    // Slower than that the direction of the velocity is mostly its error.
    private const double MinMetresPerSecond = 3;

    // A car in a curve of 25 m radius at 8 m/s turns by 18 degrees a second.
    private const double MaxRadiansPerSecond = 0.4;

    // Until two thirds of a change are followed: what a track says of the direction jumps from picture to picture.
    private const double SmoothingSeconds = 1;

    // After that it may turn in any way.
    private const double MaxGapSeconds = 2;

    private double _rate;

    /// <summary>To the right positive.</summary>
    public double RadiansPerSecond => Math.Max(-MaxRadiansPerSecond, Math.Min(MaxRadiansPerSecond, _rate));

    /// <summary>Takes the newest two of its states.</summary>
    public void Update(FollowMark before, FollowMark now)
    {
        double seconds = (now.Time - before.Time).ExactSeconds;
        if (seconds <= 0)
            return;
        if (seconds > MaxGapSeconds || Math.Min(before.Velocity.Length, now.Velocity.Length) < MinMetresPerSecond)
        {
            _rate = 0;
            return;
        }

        double turned = Math.IEEERemainder(now.Velocity.HeadingRadians - before.Velocity.HeadingRadians, 2 * Math.PI);
        _rate += seconds / (seconds + SmoothingSeconds) * ((turned / seconds) - _rate);
    }

    /// <summary>Where it is some seconds after a state.</summary>
    public PlanePoint PlaceAt(FollowMark mark, double seconds)
    {
        double half = RadiansPerSecond * seconds / 2;
        double part = Math.Abs(half) > 1e-6 ? Trig.Sin(half) / half : 1;
        double chord = mark.Velocity.Length * seconds * part;
        return mark.Place + (chord * PlanePoint.Towards(mark.Velocity.HeadingRadians + half));
    }
}
