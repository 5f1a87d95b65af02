using System;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

// Commands, poses and time.
public sealed partial class AutopilotManager
{
    private const int CommandsWaiting = 100;

    // Set-points, time-outs and the first questions for the time want a closer look than the rest.
    private static readonly TimeSpan BusyRhythm = TimeSpan.FromMilliseconds(50);

    // Answers to TIMESYNC are due by then: five at 5 Hz.
    private static readonly TimeSpan TimesyncWait = TimeSpan.FromSeconds(3);

    private readonly CommandExecutor _executor;
    private readonly AutopilotClock _clock = new();
    private readonly QueueReceiver<VehicleCommand> _commands;
    private readonly QueueSender<VehicleCommandResult> _answers;
    private readonly QueueSender<PoseSample> _poses;
    private readonly MessagePublisher<CommandAuthority> _authority;
    private ClockBasis _toldBasis;
    private TimeSpan _askingSince;

    private void ExecuteCommands()
    {
        while (_commands.TryPop(out VehicleCommand command))
            _executor.Take(command, Now);
        _executor.Run(_tracker.State, _ownAddress.Value, Now);

        CommandOutbox outbox = _executor.Outbox;
        while (outbox.Notes.Count > 0)
            Log(outbox.Notes.Dequeue());
        while (outbox.Frames.Count > 0)
            _outgoing.Push(new OutgoingFrame { Frame = outbox.Frames.Dequeue() });
        PostAuthority();
        while (outbox.Answers.Count > 0)
            Answer(outbox.Answers.Dequeue());
    }

    private void Answer(in VehicleCommandResult answer)
    {
        if (answer.Outcome != VehicleCommandOutcome.Accepted)
            Log($"command {answer.Id} {answer.Kind}: {answer.Outcome}, {answer.Text}");
        if (_answers.Push(answer) == PushResult.Rejected)
            Log($"the answer to command {answer.Id} was dropped: the queue of answers is full");
    }

    private void PostAuthority()
    {
        ref CommandAuthority posted = ref _authority.Value;
        if (posted.State == _executor.Authority.State)
            return;
        posted = _executor.Authority;
        _authority.PostStamped(posted.Since);
    }

    private void TakeHeartbeat(in LinkFrame frame, VehicleEvents events)
    {
        if (frame.Frame.MessageId == Heartbeat.MavlinkId && (events & VehicleEvents.OfOther) == 0)
            _executor.TakeHeartbeat(_tracker.State, frame.Time);
    }

    private void HandleReboot(TimeSpan time)
    {
        VehicleState vehicle = _tracker.State;
        bool wasFlying = vehicle.IsArmed
            || vehicle.LandedState is MavLandedState.InAir or MavLandedState.Takeoff or MavLandedState.Landing;
        _executor.TakeReboot(wasFlying, time);
        _clock.Restart(time);
    }

    private void TakePose(in LinkFrame frame, VehicleEvents events)
    {
        bool isPosition = frame.Frame.MessageId == GlobalPositionInt.MavlinkId;
        if ((events & VehicleEvents.Changed) == 0 || !(isPosition || frame.Frame.MessageId == Attitude.MavlinkId))
            return;
        if ((events & (VehicleEvents.OfOther | VehicleEvents.Refused)) != 0)
            return;

        ref readonly VehicleState vehicle = ref _tracker.State;
        var pose = new PoseSample { Time = _clock.Map(_tracker.BootTimeMs, frame.Time) };
        if (isPosition)
        {
            pose.Kind = PoseSampleKind.Position;
            pose.Position = vehicle.Position;
            pose.HeightAboveHomeMetres = vehicle.HeightAboveHomeMetres;
            pose.VelocityNed = vehicle.VelocityNed;
        }
        else
        {
            pose.Kind = PoseSampleKind.Attitude;
            pose.Attitude = vehicle.Attitude;
            pose.Rates = vehicle.Rates;
        }

        _poses.Push(pose);
        TellBasis(frame.Time);
    }

    private void TakeTime(in LinkFrame frame)
    {
        MavlinkFrame mavlink = frame.Frame;
        if (mavlink.MessageId != Timesync.MavlinkId || !_tracker.IsFromAutopilot(mavlink))
            return;
        mavlink.TryDecode(out Timesync message);
        _clock.Take(message, frame.Time);
    }

    private void StartAskingForTime(TimeSpan time)
    {
        _askingSince = time;
        if (_options.RequestsRates)
            _clock.Requests.Start(time);
    }

    private void RequestTime()
    {
        if (!_clock.Requests.TryNext(Now, out Timesync request))
            return;
        OwnAddress own = _ownAddress.Value;
        request.TargetSystem = _tracker.State.SystemId;
        request.TargetComponent = _tracker.State.ComponentId;
        _outgoing.Push(new OutgoingFrame { Frame = MavlinkFrame.Create(request, own.SystemId, own.ComponentId, sequence: 0) });
    }

    // Said once, and again when it is another; while answers may still come there is nothing to say.
    private void TellBasis(TimeSpan now)
    {
        ClockBasis basis = _clock.BasisAt(now);
        bool mayStillCome = basis == ClockBasis.Arrival && _options.RequestsRates && now - _askingSince < TimesyncWait;
        if (basis == _toldBasis || basis == ClockBasis.None || mayStillCome)
            return;
        _toldBasis = basis;
        Log(basis == ClockBasis.Timesync
            ? FormattableString.Invariant(
                $"the autopilot's time is known by TIMESYNC (shortest round trip {_clock.Timesync.ShortestRoundTripSeconds * 1000:0.0} ms)")
            : "the autopilot's time is estimated by when its messages come in: "
                + (_options.RequestsRates ? "it does not answer TIMESYNC" : "nobody is asked in a replay"));
    }
}
