using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Knows who commands. Once we do, the mode of every heartbeat must be one that we asked for; any other one is the
/// pilot's or the autopilot's, and takes the command away for the rest of the run. No I/O, one thread.
/// </summary>
/// <remarks>
/// A heartbeat may have been on its way while we asked: the mode before is no takeover until the grace is over. A mode
/// that we asked for stays ours also when its acknowledgement was lost, until a heartbeat after the grace shows that
/// the autopilot did not take it.
/// </remarks>
internal sealed class AuthorityMonitor(bool mayCommand)
{
    /// <summary>How long after our request a heartbeat may still show the mode before.</summary>
    public static readonly TimeSpan Grace = TimeSpan.FromSeconds(1.5);

    private const int Remembered = 4;

    private readonly (uint Mode, TimeSpan LastSent)[] _asked = new (uint, TimeSpan)[Remembered];
    private readonly (uint Mode, TimeSpan Until)[] _before = new (uint, TimeSpan)[Remembered];
    private int _askedCount;
    private int _nextBefore;
    private CommandAuthority _authority = new()
    {
        State = mayCommand ? CommandAuthorityState.Free : CommandAuthorityState.Observing
    };
    private uint _mode;

    public ref readonly CommandAuthority Authority => ref _authority;

    public bool MayCommand => _authority.State is CommandAuthorityState.Free or CommandAuthorityState.Ours;

    /// <summary>Something is about to be sent: from now on we command.</summary>
    /// <param name="mode">The mode that the last heartbeat showed.</param>
    /// <param name="now">The time.</param>
    public void Begin(uint mode, TimeSpan now)
    {
        if (_authority.State != CommandAuthorityState.Free)
            return;
        _authority = new CommandAuthority { State = CommandAuthorityState.Ours, Since = now };
        _mode = mode;
        _askedCount = 0;
        Array.Clear(_before, 0, Remembered);
    }

    /// <summary>A command is sent by which the autopilot takes a mode.</summary>
    public void Ask(uint mode, TimeSpan now)
    {
        Withdraw(mode);
        if (_askedCount == Remembered)
            RemoveAsked(0);
        _asked[_askedCount++] = (mode, now);
    }

    /// <summary>The autopilot refused the mode: it is not ours.</summary>
    public void Withdraw(uint mode)
    {
        for (int i = _askedCount - 1; i >= 0; i--)
        {
            if (_asked[i].Mode == mode)
                RemoveAsked(i);
        }
    }

    /// <summary>Takes the mode of a heartbeat.</summary>
    /// <param name="mode">The mode.</param>
    /// <param name="name">Its name, for people.</param>
    /// <param name="profile">What the autopilot does by itself; null where that is not known.</param>
    /// <param name="time">When the heartbeat came.</param>
    /// <returns>True where it takes the command away, now.</returns>
    public bool TakeMode(uint mode, string? name, VehicleProfile? profile, TimeSpan time)
    {
        if (_authority.State != CommandAuthorityState.Ours)
            return false;
        if (mode == _mode)
        {
            ForgetWhatHadNoEffect(time);
            return false;
        }

        for (int i = 0; i < _askedCount; i++)
        {
            if (_asked[i].Mode == mode)
            {
                ChangeTo(mode, _asked[i].LastSent + Grace);
                return false;
            }
        }

        if (WasBefore(mode, time))
            return false;
        if (profile?.FollowsByItself(_mode, mode) == true)
        {
            ChangeTo(mode, time + Grace);
            return false;
        }

        TakeAway("mode " + name, time);
        return true;
    }

    /// <summary>
    /// The autopilot has rebooted: on the ground nothing is lost but what we asked for, in flight it is no longer our
    /// flight.
    /// </summary>
    /// <returns>True where it takes the command away, now.</returns>
    public bool TakeReboot(bool inFlight, TimeSpan time)
    {
        if (_authority.State != CommandAuthorityState.Ours)
            return false;
        if (!inFlight)
        {
            _authority = new CommandAuthority { State = CommandAuthorityState.Free, Since = time };
            return false;
        }

        TakeAway("a reboot of the autopilot", time);
        return true;
    }

    private void TakeAway(string by, TimeSpan time)
        => _authority = new CommandAuthority { State = CommandAuthorityState.TakenAway, TakenBy = by, Since = time };

    // What was asked for earlier may have been passed through on the way.
    private void ChangeTo(uint mode, TimeSpan beforeUntil)
    {
        Remember(_mode, beforeUntil);
        for (int i = 0; i < _askedCount; i++)
        {
            if (_asked[i].Mode == mode)
                continue;
            if (_asked[i].LastSent + Grace <= beforeUntil)
                Remember(_asked[i].Mode, beforeUntil);
        }

        for (int i = _askedCount - 1; i >= 0; i--)
        {
            if (_asked[i].Mode == mode || _asked[i].LastSent + Grace <= beforeUntil)
                RemoveAsked(i);
        }

        _mode = mode;
    }

    private void ForgetWhatHadNoEffect(TimeSpan time)
    {
        for (int i = _askedCount - 1; i >= 0; i--)
        {
            if (time > _asked[i].LastSent + Grace && _asked[i].Mode != _mode)
                RemoveAsked(i);
        }
    }

    private void Remember(uint mode, TimeSpan until)
    {
        _before[_nextBefore] = (mode, until);
        _nextBefore = (_nextBefore + 1) % Remembered;
    }

    private bool WasBefore(uint mode, TimeSpan time)
    {
        foreach ((uint before, TimeSpan until) in _before)
        {
            if (before == mode && time <= until)
                return true;
        }

        return false;
    }

    private void RemoveAsked(int index)
    {
        _askedCount--;
        for (int i = index; i < _askedCount; i++)
            _asked[i] = _asked[i + 1];
    }
}
