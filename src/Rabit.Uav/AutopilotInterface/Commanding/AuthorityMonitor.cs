using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Knows who commands. Once we do, every report of the mode must show ours; any other one is the pilot's or the
/// autopilot's and takes the command away, until the operator gives it back. No I/O, one thread.
/// </summary>
/// <remarks>
/// Ours is the mode whose command was acknowledged last, or that the reports showed after we asked for it; before the
/// first command, and when the operator gives control, the mode reported at that moment. There is no time in which
/// another mode is ignored. Only a report of the mode before, within <see cref="ConfirmationTime"/> of the
/// acknowledgement and before any of the new one, has to come twice: on PX4 the acknowledgement leaves some
/// milliseconds before the reports change.
/// </remarks>
internal sealed class AuthorityMonitor(bool mayCommand)
{
    /// <summary>How long after an acknowledgement a report of the mode before has to be confirmed by another.</summary>
    public static readonly TimeSpan ConfirmationTime = TimeSpan.OfSeconds(0.3);

    // Reports that left the autopilot together confirm nothing; its main loop takes less than this.
    private static readonly TimeSpan MinConfirmationGap = TimeSpan.FromMilliseconds(20);

    // How long a mode that the autopilot takes at a height of its own waits for a report of that height: positions come
    // some times a second, are late by as much, and as noisy as half a metre.
    private static readonly TimeSpan MaxSettlingTime = TimeSpan.FromSeconds(2);

    private const string Reboot = "a reboot of the autopilot";

    // Messages with the time since boot come only once their rates have been asked for again.
    private static readonly TimeSpan MaxRebootDelay = TimeSpan.FromSeconds(10);

    // A mode and the one that replaced it before its answer; more are never unanswered at a time.
    private const int MaxUnanswered = 4;

    private readonly uint[] _unanswered = new uint[MaxUnanswered];
    private int _unansweredCount;
    private CommandAuthority _authority = new()
    {
        State = mayCommand ? CommandAuthorityState.Free : CommandAuthorityState.Observing
    };
    private uint _mode;
    private uint _modeBefore;
    private TimeSpan _changedAt = TimeSpan.MinValue;
    private TimeSpan? _doubtedAt;
    private TimeSpan? _settlingSince;
    private bool _isShown;
    private bool _hasBeenArmed;

    public ref readonly CommandAuthority Authority => ref _authority;

    public bool MayCommand => _authority.State is CommandAuthorityState.Free or CommandAuthorityState.Ours;

    /// <summary>Whether the next report decides, and is wanted at once.</summary>
    public bool NeedsReport => _doubtedAt is not null || _settlingSince is not null;

    /// <summary>Whether a mode that we asked for has not been answered.</summary>
    public bool IsModeUnanswered => _unansweredCount > 0;

    /// <summary>Something is about to be sent: from now on we command.</summary>
    /// <param name="mode">The mode that the last report showed.</param>
    /// <param name="now">The time.</param>
    public void Begin(uint mode, TimeSpan now)
    {
        if (_authority.State == CommandAuthorityState.Free)
            MakeOurs(mode, now);
    }

    /// <summary>The operator gives the command to us.</summary>
    /// <param name="mode">The mode that is reported at this moment.</param>
    /// <param name="now">The time.</param>
    public void GiveControl(uint mode, TimeSpan now)
    {
        if (_authority.State != CommandAuthorityState.Observing)
            MakeOurs(mode, now);
    }

    /// <summary>A command is sent by which the autopilot takes a mode.</summary>
    public void Ask(uint mode)
    {
        Withdraw(mode);
        if (_unansweredCount == MaxUnanswered)
            RemoveUnanswered(0);
        _unanswered[_unansweredCount++] = mode;
    }

    /// <summary>The autopilot acknowledged a mode: it is ours, and nothing asked for before is still to come.</summary>
    public void Acknowledge(uint mode, TimeSpan time)
    {
        _unansweredCount = 0;
        ChangeTo(mode, time);
    }

    /// <summary>The autopilot rejected the mode: it is not ours.</summary>
    public void Withdraw(uint mode)
    {
        for (int i = _unansweredCount - 1; i >= 0; i--)
        {
            if (_unanswered[i] == mode)
                RemoveUnanswered(i);
        }
    }

    /// <summary>Takes a report of the mode.</summary>
    /// <param name="vehicle">The state after it.</param>
    /// <param name="profile">What the autopilot does by itself; null where that is not known.</param>
    /// <param name="takeOffHeightMetres">The height of our take-off above home.</param>
    /// <param name="time">When it was received.</param>
    /// <returns>True where it takes the command away, now.</returns>
    public bool TakeReport(
        in VehicleState vehicle, VehicleProfile? profile, double takeOffHeightMetres, TimeSpan time)
    {
        if (_authority.State != CommandAuthorityState.Ours)
            return false;

        // After a flight no mode is ours: PX4 then reports the one before.
        if (_hasBeenArmed && !vehicle.IsArmed)
        {
            _authority = new CommandAuthority { State = CommandAuthorityState.Free, Since = time };
            return false;
        }

        _hasBeenArmed |= vehicle.IsArmed;
        uint mode = vehicle.CustomMode;
        if (mode == _mode)
        {
            Withdraw(mode);
            _isShown = true;
            _doubtedAt = _settlingSince = null;
            return false;
        }

        if (IsUnanswered(mode) || profile?.FollowsByItself(_mode, vehicle, takeOffHeightMetres) == true)
        {
            Withdraw(mode);
            ChangeTo(mode, time);
            _isShown = true;
            return false;
        }

        if (MaySettle(vehicle, profile, takeOffHeightMetres, time) || MayBeLate(mode, time))
            return false;
        TakeAway(TakeoverCause.Mode, "mode " + vehicle.Mode, time);
        return true;
    }

    /// <summary>
    /// The autopilot has rebooted: on the ground nothing is lost but what we asked for, in flight it is no longer our
    /// flight.
    /// </summary>
    /// <returns>True where it takes the command away, now.</returns>
    public bool TakeReboot(bool inFlight, TimeSpan time)
    {
        // The mode in which it started may have been reported before.
        bool isCause = _authority is { State: CommandAuthorityState.TakenAway, Cause: not TakeoverCause.OtherCommander }
            && inFlight && time - _authority.Since <= MaxRebootDelay;
        if (isCause)
            Explain(TakeoverCause.Reboot, Reboot);
        if (_authority.State != CommandAuthorityState.Ours)
            return false;
        if (!inFlight)
        {
            _authority = new CommandAuthority { State = CommandAuthorityState.Free, Since = time };
            return false;
        }

        TakeAway(TakeoverCause.Reboot, Reboot, time);
        return true;
    }

    /// <summary>Something else than a mode takes the command away.</summary>
    public void TakeAway(TakeoverCause cause, string by, TimeSpan time)
    {
        _doubtedAt = _settlingSince = null;
        _authority = new CommandAuthority
        {
            State = CommandAuthorityState.TakenAway,
            Cause = cause,
            TakenBy = by,
            Since = time
        };
    }

    /// <summary>What a takeover turned out to be.</summary>
    public void Explain(TakeoverCause cause, string by)
    {
        _authority.Cause = cause;
        _authority.TakenBy = by;
    }

    /// <summary>Whether Autopilot Interface returns by itself.</summary>
    public void SetReturningByItself(bool isReturning) => _authority.IsReturningByItself = isReturning;

    private void MakeOurs(uint mode, TimeSpan now)
    {
        _authority = new CommandAuthority { State = CommandAuthorityState.Ours, Since = now };
        _mode = _modeBefore = mode;
        _unansweredCount = 0;
        _doubtedAt = _settlingSince = null;
        _hasBeenArmed = false;
    }

    private void ChangeTo(uint mode, TimeSpan time)
    {
        if (mode != _mode)
            _modeBefore = _mode;
        _mode = mode;
        _changedAt = time;
        _isShown = false;
        _doubtedAt = _settlingSince = null;
    }

    private bool MayBeLate(uint mode, TimeSpan time)
    {
        if (mode != _modeBefore || _isShown)
            return false;
        if (_doubtedAt is { } doubted)
            return time - doubted < MinConfirmationGap;
        if (time - _changedAt > ConfirmationTime)
            return false;
        _doubtedAt = time;
        return true;
    }

    // Meanwhile no mode command goes out: no report shows our mode.
    private bool MaySettle(
        in VehicleState vehicle, VehicleProfile? profile, double takeOffHeightMetres, TimeSpan time)
    {
        if (profile?.MayFollowByItself(_mode, vehicle, takeOffHeightMetres) != true)
            return false;
        _settlingSince ??= time;
        return time - _settlingSince.Value <= MaxSettlingTime;
    }

    private bool IsUnanswered(uint mode)
    {
        for (int i = 0; i < _unansweredCount; i++)
        {
            if (_unanswered[i] == mode)
                return true;
        }

        return false;
    }

    private void RemoveUnanswered(int index)
    {
        _unansweredCount--;
        for (int i = index; i < _unansweredCount; i++)
            _unanswered[i] = _unanswered[i + 1];
    }
}
