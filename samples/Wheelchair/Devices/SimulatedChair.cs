using System;

namespace Wheelchair.Devices;

/// <summary>
/// Where the chair is: the world behind the simulated devices. It has the speed that the motors were commanded last.
/// </summary>
/// <remarks>No manager ever sees it. Its devices run on threads of their own in real time, so it has a lock.</remarks>
internal sealed class SimulatedChair(double wallAtMetres)
{
    private readonly object _gate = new();   // guards all that follows
    private double _positionMetres;
    private double _speedMetresPerSecond;
    private TimeSpan _at;

    public void SetSpeed(double metresPerSecond, TimeSpan at)
    {
        lock (_gate)
        {
            MoveOn(at);
            _speedMetresPerSecond = metresPerSecond;
        }
    }

    /// <summary>From the footrest to the wall; negative behind it.</summary>
    public double DistanceToWall(TimeSpan at)
    {
        lock (_gate)
        {
            MoveOn(at);
            return wallAtMetres - _positionMetres;
        }
    }

    private void MoveOn(TimeSpan to)
    {
        if (to <= _at)
            return;
        _positionMetres += _speedMetresPerSecond * (to - _at).TotalSeconds;
        _at = to;
    }
}
