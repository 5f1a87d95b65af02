using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The mode switch of the remote control, or of a ground station that overrides its channel: a position is taken when
/// it has been stable for 200 ms. The position at the start changes nothing.
/// </summary>
internal sealed class ModeSwitch(ParameterStore parameters, FlightController controller)
{
    // RC_OVERRIDE_TIME.
    private const double OverrideSeconds = 3;
    private const int ScriptedPositions = 1000;
    private static readonly TimeSpan StableTime = TimeSpan.FromMilliseconds(200);

    // PWM of the channel up to which each position but the last goes (RC_Channel::read_6pos_switch).
    private static readonly int[] PositionEnds = [1230, 1360, 1490, 1620, 1749];

    private readonly LossTimer _override = new();
    private int? _position;
    private int? _candidate;
    private int? _switchCount;
    private uint _mode;
    private TimeSpan _since;

    /// <summary>Whether a ground station controls the vehicle in place of the remote control.</summary>
    public bool IsOverridden(TimeSpan time) => _override.HasReceived && !_override.IsLost(time, OverrideSeconds);

    /// <summary>A ground station's value of the channel; 0 and 65535 leave it alone.</summary>
    public void Override(int pulse, TimeSpan time)
    {
        _override.Receive(time);
        if (pulse is 0 or ushort.MaxValue)
            return;
        int position = 0;
        while (position < PositionEnds.Length && pulse > PositionEnds[position])
            position++;
        if (_candidate is null)
            _position = _candidate = position;
        MoveTo(position, (uint)parameters.FlightModeAt(position), time);
    }

    /// <summary>One step.</summary>
    public void Step(in VehicleSenses senses)
    {
        _switchCount ??= senses.SwitchCount;
        if (senses.ModeOfSwitch is { } mode && senses.IsRadioReceived && senses.SwitchCount != _switchCount)
        {
            _switchCount = senses.SwitchCount;
            MoveTo(ScriptedPositions + senses.SwitchCount, mode, senses.Time);
        }

        if (_candidate == _position || senses.Time - _since < StableTime)
            return;
        _position = _candidate;
        controller.TrySetMode(_mode);
    }

    private void MoveTo(int position, uint mode, TimeSpan time)
    {
        if (position == _candidate)
            return;
        _candidate = position;
        _mode = mode;
        _since = time;
    }
}
