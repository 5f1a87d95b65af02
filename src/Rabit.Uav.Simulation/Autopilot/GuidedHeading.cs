using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>The heading in GUIDED: along the flight, a commanded heading, or a commanded rate.</summary>
internal sealed class GuidedHeading
{
    private bool _follows = true;
    private double _yaw;
    private double _rate = double.NaN;

    /// <summary>Along the flight; until there is one, the present heading.</summary>
    public void Follow(double yawNow)
    {
        _follows = true;
        _yaw = yawNow;
        _rate = double.NaN;
    }

    public void Turn(double yaw)
    {
        _follows = false;
        _yaw = yaw;
        _rate = double.NaN;
    }

    public void Set(in HeadingTarget target)
    {
        if (!double.IsNaN(target.Yaw))
            Turn(target.Yaw);
        else if (!double.IsNaN(target.YawRate))
            (_follows, _rate) = (false, target.YawRate);
    }

    /// <param name="situation">How it is.</param>
    /// <param name="along">The direction of flight; zero where it is too slow for that.</param>
    /// <param name="command">Gets the heading.</param>
    public void Fly(FlightSituation situation, NedVector along, ref MotionCommand command)
    {
        if (!double.IsNaN(_rate))
        {
            _yaw = situation.Yaw;
            command.Yaw = double.NaN;
            command.YawRate = _rate;
            return;
        }

        if (_follows && along.HorizontalLength() > 0)
            _yaw = Math.Atan2(along.East, along.North);
        command.Yaw = _yaw;
    }
}
