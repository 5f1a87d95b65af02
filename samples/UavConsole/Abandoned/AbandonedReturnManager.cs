using System;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>
/// Waits for reports of the vehicle, asks it to return where it was abandoned, and ends the run with the first answer.
/// The request goes out on the arrival of a report that still shows GUIDED; where it was not acknowledged it is
/// repeated on the next one, and sent three times at most.
/// </summary>
internal sealed class AbandonedReturnManager : RabitManager
{
    private const int MaxTries = 3;

    // ArduPilot Copter's number of the mode RTL.
    private const float ReturnMode = 6;

    // Heartbeats come once a second, landed state and position are asked for first.
    private static readonly TimeSpan ReportTime = TimeSpan.FromSeconds(4);
    private static readonly TimeSpan MaxTime = TimeSpan.FromSeconds(20);
    private static readonly TimeSpan AnswerTimeout = TimeSpan.FromSeconds(1.5);

    private readonly TimeSpan _startsAt;
    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly MessageSubscriber<OwnAddress> _own;
    private readonly MessageSubscriber<RecentItems<CommandAcknowledgement>> _acknowledgements;
    private readonly QueueSender<OutgoingFrame> _outgoing;
    private TimeSpan? _connectedSince;
    private TimeSpan _judgedHeartbeat;
    private TimeSpan? _sentAt;
    private int _tries;

    /// <param name="startsAt">When it begins to look, by the clock of the run.</param>
    public AbandonedReturnManager(TimeSpan startsAt = default)
        : base("abandoned return")
    {
        _startsAt = startsAt;
        _vehicle = Subscribe<VehicleState>(MessageNames.VehicleState, wakeOnPost: true);
        _own = Subscribe<OwnAddress>(MessageNames.OwnAddress);
        _acknowledgements = Subscribe<RecentItems<CommandAcknowledgement>>(
            MessageNames.CommandAcknowledgements, wakeOnPost: true);
        _outgoing = Send<OutgoingFrame>(MessageNames.OutgoingFrames);
        WakeUpDelay = TimeSpan.FromMilliseconds(200);
    }

    /// <summary>What was done and why, as text. After the run.</summary>
    public string Outcome { get; private set; } = "stopped before it was decided";

    /// <summary>Whether the vehicle returns, or is rightly left alone. After the run.</summary>
    public bool IsInOrder { get; private set; }

    protected override void ExecuteUnitOfWork()
    {
        if (Now < _startsAt)
            return;
        _vehicle.Fetch();
        _own.Fetch();
        if (IsAcknowledged(out MavResult result))
        {
            End($"asked to return: {result}", isInOrder: result == MavResult.Accepted);
            return;
        }

        if (Now - _startsAt > MaxTime)
            End(_tries > 0 ? "asked to return: no answer" : "no report of the vehicle; nothing is sent", false);
        else if (_vehicle.Value.IsConnected && _own.Value.IsKnown)
            Look(_vehicle.Value);
    }

    private void Look(in VehicleState vehicle)
    {
        _connectedSince ??= Now;
        bool isNewReport = vehicle.LastHeartbeatTime > _judgedHeartbeat;
        bool isKnown = vehicle.LandedState != MavLandedState.Undefined || Now - _connectedSince.Value >= ReportTime;
        if (!isNewReport || !isKnown || Now - _sentAt < AnswerTimeout)
            return;
        _judgedHeartbeat = vehicle.LastHeartbeatTime;
        if (AbandonedReturn.FindReasonToStay(vehicle) is { } reason)
            End(reason + (_tries > 0 ? " after it was asked to return" : "; nothing is sent"), isInOrder: true);
        else if (_tries < MaxTries)
            Send(vehicle);
    }

    private void Send(in VehicleState vehicle)
    {
        var command = new CommandLong
        {
            TargetSystem = vehicle.SystemId,
            TargetComponent = vehicle.ComponentId,
            Command = MavCmd.DoSetMode,
            Confirmation = (byte)_tries,
            Param1 = (float)MavModeFlag.CustomModeEnabled,
            Param2 = ReturnMode,
        };
        OwnAddress own = _own.Value;
        _ = _outgoing.Push(
            new OutgoingFrame { Frame = MavlinkFrame.Create(command, own.SystemId, own.ComponentId, sequence: 0) });
        _sentAt = Now;
        _tries++;
        Log("asked the vehicle to return");
    }

    private bool IsAcknowledged(out MavResult result)
    {
        _acknowledgements.Fetch();
        CommandAcknowledgement? answer = _sentAt is null
            ? null
            : _acknowledgements.Value.FirstOrDefault(
                a => a.Command == MavCmd.DoSetMode && a.TargetComponent == _own.Value.ComponentId);
        result = answer?.Result ?? default;
        return answer is not null;
    }

    private void End(string outcome, bool isInOrder)
    {
        (Outcome, IsInOrder) = (outcome, isInOrder);
        StopSystem(outcome);
    }
}
