using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// Compares the way of the last seconds by positions with that by velocities: a position that stands still while the
/// vehicle flies, or that jumps, disagrees. A single wrong position does so for one evaluation only.
/// </summary>
internal sealed class WayComparison
{
    // Evaluations in 5 s: what flies with 2.4 m/s is 12 m away from a position that stands still.
    private const int Steps = 20;
    private const int RecentSteps = 4;
    private const double StandstillMetres = 0.3;
    private const double FlownMetres = 1;

    // A longer gap is a loss of the position, which is another rule.
    private static readonly TimeSpan MaxGap = TimeSpan.FromSeconds(2);

    private readonly (double North, double East)[] _ways = new (double, double)[Steps];
    private readonly (double North, double East)[] _errors = new (double, double)[Steps];
    private TimeSpan? _time;
    private GeodeticPosition _position;
    private NedVector _velocity;
    private int _next;

    /// <summary>How far the two ways end from each other, metres.</summary>
    public double ErrorMetres => LengthOfSum(_errors, Steps);

    /// <summary>
    /// Whether in the last second positions stood still and velocities did not. After a jump to a place where the
    /// vehicle hovers neither moves.
    /// </summary>
    public bool StandsStill => LengthOfSum(_ways, RecentSteps) < StandstillMetres
        && LengthOfSum(_errors, RecentSteps) > FlownMetres;

    /// <summary>Updates it; called once in each evaluation.</summary>
    public void Update(in VehicleState state)
    {
        (double North, double East) way = default;
        (double North, double East) error = default;
        if (_time is { } last && state.PositionTime > last)
        {
            TimeSpan gap = state.PositionTime.Value - last;
            if (gap > MaxGap)
                Clear();
            else
                (way, error) = Compare(state, gap.ExactSeconds);
        }

        _ways[_next] = way;
        _errors[_next] = error;
        _next = (_next + 1) % Steps;
        (_time, _position, _velocity) = (state.PositionTime, state.Position, state.VelocityNed);
    }

    private ((double North, double East) Way, (double North, double East) Error) Compare(
        in VehicleState state, double seconds)
    {
        NedPosition moved = LocalNedFrame.IgnoringGeoid(_position).ToNed(state.Position);
        double north = (_velocity.North + state.VelocityNed.North) / 2 * seconds;
        double east = (_velocity.East + state.VelocityNed.East) / 2 * seconds;
        return ((moved.North, moved.East), (moved.North - north, moved.East - east));
    }

    private void Clear()
    {
        Array.Clear(_ways, 0, Steps);
        Array.Clear(_errors, 0, Steps);
    }

    private double LengthOfSum((double North, double East)[] steps, int last)
    {
        double north = 0;
        double east = 0;
        for (int i = 1; i <= last; i++)
        {
            (double stepNorth, double stepEast) = steps[(_next + Steps - i) % Steps];
            (north, east) = (north + stepNorth, east + stepEast);
        }

        return Math.Sqrt((north * north) + (east * east));
    }
}
