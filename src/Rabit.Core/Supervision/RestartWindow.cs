using System;

namespace Rabit.Core.Supervision;

/// <summary>
/// When a manager was restarted lately: so many times at most, within so long. The manager's thread only.
/// </summary>
internal sealed class RestartWindow
{
    private TimeSpan[] _times = [];   // a ring of as many as the policy allows
    private int _head;
    private int _count;

    /// <summary>Takes one restart, if there is one left, and says how long to wait before it.</summary>
    public bool TryTake(FaultPolicy policy, TimeSpan now, out TimeSpan delay)
    {
        if (_times.Length != policy.MaxRestarts)
        {
            _times = new TimeSpan[policy.MaxRestarts];
            _head = _count = 0;
        }

        while (_count > 0 && now - _times[_head] >= policy.Window)
        {
            _head = (_head + 1) % _times.Length;
            _count--;
        }

        delay = BackOff.Delay(policy.FirstDelay, policy.MaxDelay, _count);
        if (_count == _times.Length)
            return false;
        _times[(_head + _count) % _times.Length] = now;
        _count++;
        return true;
    }
}
