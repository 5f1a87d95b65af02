using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Sends the vehicle the command of the current goal: one at a time, again when it was refused or lost, never while no
/// autopilot is connected. A phase sets its goal in every tick; only a new goal is sent. The command that was sent last
/// is renewed once a second, so that Autopilot Interface sees that Mission Control works.
/// </summary>
internal sealed class CommandDispatcher(Func<VehicleCommand, bool> push, Action<string> log)
{
    // Autopilot Interface reports the result of each command; a result that never comes must not stop the mission.
    private static readonly TimeSpan ResultTimeout = TimeSpan.FromSeconds(20);

    // Two renewals may be lost or late.
    private static readonly TimeSpan Validity = TimeSpan.FromSeconds(3);

    // At least once a second, with ticks of 0.2 s of which one may be left out.
    private static readonly TimeSpan RenewalPeriod = TimeSpan.OfSeconds(0.6);

    private VehicleCommand _goal;
    private VehicleCommand _newest;
    private bool _isRenewed;
    private TimeSpan _pushTime;
    private string _text = string.Empty;
    private TimeSpan _retryAfter;
    private TimeSpan _sentTime;
    private TimeSpan _notBefore;
    private Progress _progress;
    private long _lastId;

    private enum Progress
    {
        Nothing,
        ToSend,
        Sent,
        Accepted,
    }

    /// <summary>Whether the autopilot accepted the goal.</summary>
    public bool IsAccepted => _progress == Progress.Accepted;

    /// <summary>When the goal was sent last.</summary>
    public TimeSpan SentTime => _sentTime;

    /// <summary>How often in a row a command of the kind of the goal was refused or timed out.</summary>
    public int Failures { get; private set; }

    /// <summary>Why it failed last, as text; empty where it did not.</summary>
    public string LastFailure { get; private set; } = string.Empty;

    /// <summary>What the goal is; None where there is none.</summary>
    public VehicleCommandKind GoalKind
        => _progress == Progress.Nothing ? VehicleCommandKind.None : _goal.Kind;

    /// <summary>Why we do not command, as Autopilot Interface reported it; null while we do.</summary>
    public string? NotInCommand { get; private set; }

    /// <summary>Sets the goal. The same as before changes nothing.</summary>
    /// <param name="command">Its id is chosen here.</param>
    /// <param name="text">The goal in words, for the log.</param>
    /// <param name="retryAfter">How long to wait after a refusal.</param>
    public void SetGoal(in VehicleCommand command, string text, TimeSpan retryAfter)
    {
        if (_progress != Progress.Nothing && AreSame(_goal, command))
            return;

        // Refusals of one kind of command are counted across goals: a vehicle that refuses every position is noticed.
        if (_goal.Kind != command.Kind)
            (Failures, LastFailure) = (0, string.Empty);
        _goal = command;
        _text = text;
        _retryAfter = retryAfter;
        _progress = Progress.ToSend;
        _notBefore = TimeSpan.MinValue;
    }

    /// <summary>Whether a command equals the goal; the text of a new one need not be made then.</summary>
    public bool IsGoal(in VehicleCommand command) => _progress != Progress.Nothing && AreSame(_goal, command);

    /// <summary>
    /// Sends a command beside the goal, which stays the goal: one that moves no vehicle. Not while the goal is to be
    /// sent or waits for its result, since a newer command would replace it.
    /// </summary>
    /// <returns>Its id; null where it was not sent.</returns>
    public long? SendBeside(VehicleCommand command)
    {
        command.Id = _lastId + 1;
        if (_progress != Progress.Accepted || !push(command))
            return null;
        return ++_lastId;
    }

    /// <summary>Drops the goal and renews nothing; what was sent stays sent.</summary>
    public void Clear()
    {
        _progress = Progress.Nothing;
        _isRenewed = false;
        (Failures, LastFailure) = (0, string.Empty);
        NotInCommand = null;
    }

    /// <summary>Has the goal sent again: it may have been lost, or the vehicle may have dropped it.</summary>
    public void Resend()
    {
        if (_progress != Progress.Nothing)
            _progress = Progress.ToSend;
    }

    /// <summary>Sends the goal if it is due.</summary>
    public void Send(TimeSpan now)
    {
        if (_progress == Progress.Sent && now - _sentTime > ResultTimeout)
            Fail("no result", now);
        if (_progress != Progress.ToSend || now < _notBefore)
            return;
        _goal.Id = _lastId + 1;
        _goal.Validity = Validity;

        // A full queue: the next tick tries again.
        if (!push(_goal))
            return;
        _lastId++;
        (_newest, _isRenewed) = (_goal, true);
        (_sentTime, _pushTime) = (now, now);
        _progress = Progress.Sent;
        log($"command {_lastId}: {_text}");
    }

    /// <summary>
    /// Renews the command that was sent last, also while it is not answered or no autopilot is connected: a renewal
    /// says that we work, and sends nothing.
    /// </summary>
    public void Renew(TimeSpan now)
    {
        if (_isRenewed && now - _pushTime >= RenewalPeriod && push(_newest))
            _pushTime = now;
    }

    /// <summary>Applies a result; one of an older command is ignored.</summary>
    public void Apply(in VehicleCommandResult result, TimeSpan now)
    {
        if (result.Id != _goal.Id || _progress != Progress.Sent)
            return;
        switch (result.Outcome)
        {
            case VehicleCommandOutcome.Accepted:
                _progress = Progress.Accepted;
                (Failures, LastFailure) = (0, string.Empty);
                break;
            case VehicleCommandOutcome.NotInCommand:
                NotInCommand = result.Text ?? "not in command";
                _progress = Progress.Nothing;
                _isRenewed = false;
                break;
            case VehicleCommandOutcome.Refused:
                Fail("refused" + Reason(result.Text), now);
                break;
            default:
                Fail("timed out" + Reason(result.Text), now);
                break;
        }
    }

    private static string Reason(string? text) => string.IsNullOrEmpty(text) ? string.Empty : ": " + text;

    private void Fail(string reason, TimeSpan now)
    {
        Failures++;
        LastFailure = reason;
        _progress = Progress.ToSend;
        _notBefore = now + _retryAfter;
        log($"command {_goal.Id} {reason}");
    }

    // NaN is a value here: it leaves something to the autopilot.
    private static bool AreSame(in VehicleCommand a, in VehicleCommand b)
        => a.Kind == b.Kind
            && a.Latitude.Equals(b.Latitude) && a.Longitude.Equals(b.Longitude)
            && a.HeightAboveHomeMetres.Equals(b.HeightAboveHomeMetres)
            && a.SpeedMetresPerSecond.Equals(b.SpeedMetresPerSecond) && a.Yaw.Equals(b.Yaw)
            && a.LoiterRadiusMetres.Equals(b.LoiterRadiusMetres)
            && a.CameraPitch.Equals(b.CameraPitch) && a.CameraYaw.Equals(b.CameraYaw);
}
