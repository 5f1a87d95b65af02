using System;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

// The place to land on as the camera sees it, for the autopilot's own precision landing.
public sealed partial class AutopilotManager
{
    // ArduPilot forgets a target after a second, and goes back in its own past for the time of the picture.
    private static readonly TimeSpan MaxTargetAge = TimeSpan.OfSeconds(0.5);

    private readonly MessageSubscriber<LandingTargetObservation>? _landingTarget; // null where it is not sent
    private readonly LandingTargetEncoder _landing = new();

    private VehicleEvents Take(in LinkFrame frame, in LocalPositionNed position)
    {
        VehicleEvents events = Complete(frame, _tracker.Update(frame));
        if (_tracker.IsFromAutopilot(frame.Frame)
            && !_landing.Take(position, _clock.Map(position.TimeBootMs, frame.Time)))
            Count(VehicleEvents.Refused);
        return events;
    }

    private void SendLandingTarget()
    {
        if (_landingTarget is null || !_landingTarget.Fetch())
            return;
        ref readonly LandingTargetObservation target = ref _landingTarget.Value;
        _hasNewStatistics = true;
        if (_connection is not { } connection || !_tracker.State.IsConnected || Now - target.Time > MaxTargetAge
            || !_landing.TryEncode(target, _tracker.State.Autopilot, out LandingTarget message))
        {
            _statistics.Value.LandingTargetsNotSent++;
            return;
        }

        // What finds no room is counted by the queue.
        _ = _outgoing.Push(new OutgoingFrame
        {
            Frame = connection.Sender.Create(message),
            ValidUntil = target.Time + MaxTargetAge,
        });
        _statistics.Value.LandingTargetsSent++;
    }
}
