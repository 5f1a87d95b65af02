using System;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

// Commands, poses and time.
public sealed partial class AutopilotManager
{
    private const int CommandsWaiting = 100;

    // Set-points, time-outs and the first requests for the time are due more often than the rest.
    private static readonly TimeSpan BusyDelay = TimeSpan.FromMilliseconds(50);

    // What moves the vehicle follows from what was reported a moment ago; after a stall of Communications it no longer
    // does. Of a command the next repetition is sent, of set-points the next one.
    private static readonly TimeSpan MaxCommandDelay = TimeSpan.OfSeconds(0.3);

    // Something that is due now.
    private static readonly TimeSpan MinDelay = TimeSpan.FromMilliseconds(1);

    // Answers to TIMESYNC are due by then: five at 5 Hz.
    private static readonly TimeSpan TimesyncWait = TimeSpan.FromSeconds(3);

    private readonly CommandExecutor _executor;
    private readonly AutopilotClock _clock = new();
    private readonly GimbalTracker _gimbal = new();
    private readonly QueueReceiver<VehicleCommand> _commands;
    private readonly QueueSender<VehicleCommandResult> _answers;
    private readonly QueueSender<PoseSample> _poses;
    private readonly MessagePublisher<CommandAuthority> _authority;
    private ClockBasis _reportedBasis;
    private TimeSpan _requestingSince;

    private void ExecuteCommands()
    {
        while (_commands.TryPop(out VehicleCommand command))
            _executor.Take(command, Now);
        _executor.Run(_tracker.State, _ownAddress.Value, Now);

        CommandOutbox outbox = _executor.Outbox;
        while (outbox.Notes.Count > 0)
            Log(outbox.Notes.Dequeue());
        while (outbox.Frames.Count > 0)
            _ = _outgoing.Push(new OutgoingFrame
            {
                Frame = outbox.Frames.Dequeue(),
                ValidUntil = Now + MaxCommandDelay,
            });
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
        ref readonly CommandAuthority current = ref _executor.Authority;
        if (posted.State == current.State && posted.Cause == current.Cause
            && posted.IsReturningByItself == current.IsReturningByItself)
            return;
        posted = current;
        _authority.PostStamped(posted.Since);
    }

    private void HandleReboot(TimeSpan time)
    {
        VehicleState vehicle = _tracker.State;
        bool wasFlying = vehicle.IsArmed
            || vehicle.LandedState is MavLandedState.InAir or MavLandedState.Takeoff or MavLandedState.Landing;
        _executor.TakeReboot(wasFlying, time);
        _clock.Restart(time);
        _landing.Clear();
    }

    private void PushPose(PoseSampleKind kind, TimeSpan arrival)
    {
        ref readonly VehicleState vehicle = ref _tracker.State;
        var pose = new PoseSample
        {
            Kind = kind,
            Time = _clock.Map(_tracker.BootTimeMs, arrival),
            TimeErrorSeconds = _clock.ErrorSecondsAt(arrival),
        };
        if (kind == PoseSampleKind.Position)
        {
            pose.Position = vehicle.Position;
            pose.HeightAboveHomeMetres = vehicle.HeightAboveHomeMetres;
            pose.VelocityNed = vehicle.VelocityNed;
        }
        else
        {
            pose.Attitude = vehicle.Attitude;
            pose.Rates = vehicle.Rates;
        }

        _ = _poses.Push(pose);
        ReportBasis(arrival);
    }

    private void PushGimbal(in GimbalAttitude gimbal, uint bootTimeMs, TimeSpan arrival)
        => _ = _poses.Push(new PoseSample
        {
            Kind = PoseSampleKind.Gimbal,
            Time = _clock.Map(bootTimeMs, arrival),
            TimeErrorSeconds = _clock.ErrorSecondsAt(arrival),
            Gimbal = gimbal,
        });

    private void StartRequestingTime(TimeSpan time)
    {
        _requestingSince = time;
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
        _ = _outgoing.Push(
            new OutgoingFrame { Frame = MavlinkFrame.Create(request, own.SystemId, own.ComponentId, sequence: 0) });
    }

    // Logged once, and again when it is another; while answers may still come there is nothing to report.
    private void ReportBasis(TimeSpan now)
    {
        ClockBasis basis = _clock.BasisAt(now);
        bool mayStillCome = basis == ClockBasis.Arrival && _options.RequestsRates
            && now - _requestingSince < TimesyncWait;
        if (basis == _reportedBasis || basis == ClockBasis.None || mayStillCome)
            return;
        _reportedBasis = basis;
        Log(basis == ClockBasis.Timesync
            ? FormattableString.Invariant(
                $"the autopilot's time is known by TIMESYNC (shortest round trip {_clock.Timesync.ShortestRoundTripSeconds * 1000:0.0} ms)")
            : "the autopilot's time is estimated by when its messages come in: "
                + (_options.RequestsRates ? "it does not answer TIMESYNC" : "in a replay it is not asked"));
    }
}
