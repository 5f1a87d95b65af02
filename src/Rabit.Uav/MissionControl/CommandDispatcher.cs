using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Sees to it that the vehicle has been told what is wanted of it now: one command at a time, again when it was refused or lost, never
/// while nobody hears it. A phase says again and again what it wants; only what is new is sent.
/// </summary>
internal sealed class CommandDispatcher(Func<VehicleCommand, bool> push, Action<string> log)
{
    // Autopilot Interface answers each command; should it not, the mission must not hang on it.
    private static readonly TimeSpan AnswerWithin = TimeSpan.FromSeconds(20);

    private VehicleCommand _wanted;
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

    /// <summary>Whether the vehicle does what is wanted.</summary>
    public bool IsAccepted => _progress == Progress.Accepted;

    /// <summary>When it was sent last.</summary>
    public TimeSpan SentTime => _sentTime;

    /// <summary>How often in a row a command of the kind that is wanted was refused or not answered.</summary>
    public int Failures { get; private set; }

    /// <summary>Why it failed last, for people; empty where it did not.</summary>
    public string LastFailure { get; private set; } = string.Empty;

    /// <summary>Why we were told that we do not command; null where we were not.</summary>
    public string? NotInCommand { get; private set; }

    /// <summary>Says what is wanted now. The same as before changes nothing.</summary>
    /// <param name="command">Its id is chosen here.</param>
    /// <param name="text">The same for people.</param>
    /// <param name="retryAfter">How long to wait after a refusal.</param>
    public void Want(in VehicleCommand command, string text, TimeSpan retryAfter)
    {
        if (_progress != Progress.Nothing && AreSame(_wanted, command))
            return;

        // A vehicle that refuses to go here and there and anywhere is to be noticed.
        if (_wanted.Kind != command.Kind)
            (Failures, LastFailure) = (0, string.Empty);
        _wanted = command;
        _text = text;
        _retryAfter = retryAfter;
        _progress = Progress.ToSend;
        _notBefore = TimeSpan.MinValue;
    }

    /// <summary>Whether a command like this is the wanted one; the text of a new one need not be made then.</summary>
    public bool IsWanted(in VehicleCommand command) => _progress != Progress.Nothing && AreSame(_wanted, command);

    /// <summary>Nothing is wanted any more; what was sent stays sent.</summary>
    public void WantNothing()
    {
        _progress = Progress.Nothing;
        (Failures, LastFailure) = (0, string.Empty);
    }

    /// <summary>Sends again what is wanted: it may have been lost, or the vehicle may have forgotten it.</summary>
    public void SendAgain()
    {
        if (_progress != Progress.Nothing)
            _progress = Progress.ToSend;
    }

    /// <summary>Sends what is to be sent.</summary>
    public void Send(TimeSpan now)
    {
        if (_progress == Progress.Sent && now - _sentTime > AnswerWithin)
            Fail("no answer", now);
        if (_progress != Progress.ToSend || now < _notBefore)
            return;
        _wanted.Id = _lastId + 1;

        // A full queue: it is tried again with the next look at things.
        if (!push(_wanted))
            return;
        _lastId++;
        _sentTime = now;
        _progress = Progress.Sent;
        log($"command {_lastId}: {_text}");
    }

    /// <summary>Takes an answer in; one to an older command means nothing any more.</summary>
    public void Take(in VehicleCommandResult answer, TimeSpan now)
    {
        if (answer.Id != _lastId || _progress != Progress.Sent)
            return;
        switch (answer.Outcome)
        {
            case VehicleCommandOutcome.Accepted:
                _progress = Progress.Accepted;
                (Failures, LastFailure) = (0, string.Empty);
                break;
            case VehicleCommandOutcome.NotInCommand:
                NotInCommand = answer.Text ?? "not in command";
                _progress = Progress.Nothing;
                break;
            case VehicleCommandOutcome.Refused:
                Fail("refused" + Reason(answer.Text), now);
                break;
            default:
                Fail("timed out" + Reason(answer.Text), now);
                break;
        }
    }

    private static string Reason(string? text) => string.IsNullOrEmpty(text) ? string.Empty : ": " + text;

    private void Fail(string why, TimeSpan now)
    {
        Failures++;
        LastFailure = why;
        _progress = Progress.ToSend;
        _notBefore = now + _retryAfter;
        log($"command {_lastId} {why}");
    }

    // NaN is a value here: it leaves something to the autopilot.
    private static bool AreSame(in VehicleCommand a, in VehicleCommand b)
        => a.Kind == b.Kind
            && a.LatitudeRadians.Equals(b.LatitudeRadians) && a.LongitudeRadians.Equals(b.LongitudeRadians)
            && a.HeightAboveHomeMetres.Equals(b.HeightAboveHomeMetres)
            && a.SpeedMetresPerSecond.Equals(b.SpeedMetresPerSecond) && a.YawRadians.Equals(b.YawRadians)
            && a.CameraPitchRadians.Equals(b.CameraPitchRadians) && a.CameraYawRadians.Equals(b.CameraYawRadians);
}
