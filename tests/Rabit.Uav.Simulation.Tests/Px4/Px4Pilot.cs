using System.Text.Json;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation.Tests.Px4;

/// <summary>The pilot's sticks: MANUAL_CONTROL at 10 Hz over the link of the ground station.</summary>
internal sealed class Px4Pilot
{
    private const double Period = 0.1;

    private bool _isOn;
    private double _next;
    private ManualControl _sticks;
    private double _rampStart;
    private double _rampSeconds;
    private double _from;
    private double _to;

    public void Do(string what, JsonElement action, double time)
    {
        switch (what)
        {
            case "MANUAL_CONTROL starts":
                Move(action);
                Start(time);
                break;
            case "MANUAL_CONTROL stops": _isOn = false; break;
            case "MANUAL_CONTROL sticks": Move(action); break;
            case "MANUAL_CONTROL ramp" or "MANUAL_CONTROL ramp back":
                (_from, _to) = (action.GetProperty("x_from").GetDouble(), action.GetProperty("x_to").GetDouble());
                _rampSeconds = action.GetProperty("seconds").GetDouble();
                _rampStart = time;
                break;
        }
    }

    public void Start(double time)
    {
        _isOn = true;
        _next = time;
        _sticks.Target = 1;
    }

    public void Stop() => _isOn = false;

    public void Move(short x, short y, short z, short r)
        => (_sticks.X, _sticks.Y, _sticks.Z, _sticks.R, _rampSeconds) = (x, y, z, r, 0);

    public void Step(Px4Flyer flyer)
    {
        if (!_isOn || flyer.Time < _next)
            return;
        _next += Period;
        if (_rampSeconds > 0)
        {
            double part = System.Math.Min(1, (flyer.Time - _rampStart) / _rampSeconds);
            _sticks.X = (short)(_from + (part * (_to - _from)));
        }

        flyer.Send(1, _sticks, 255, 190);
    }

    private void Move(JsonElement action) => Move(
        action.GetProperty("x").GetInt16(), action.GetProperty("y").GetInt16(), action.GetProperty("z").GetInt16(),
        action.GetProperty("r").GetInt16());
}
