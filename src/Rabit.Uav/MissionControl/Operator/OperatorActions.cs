using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Refuses what cannot be, and does what needs no change of the phase. What changes the phase stays pending for the
/// failsafes, which come before it.
/// </summary>
internal sealed class OperatorActions(Func<TrackDecision, bool> decide)
{
    // Sensor Fusion answers by its next list of tracks.
    private static readonly TimeSpan MaxDecisionTime = TimeSpan.FromSeconds(3);

    private readonly List<(OperatorRequest Request, TimeSpan Since)> _decided = [];

    /// <summary>In each tick.</summary>
    /// <param name="flight">The state of the mission.</param>
    /// <param name="phase">The phase.</param>
    /// <param name="isOver">Whether nothing more will happen.</param>
    public void Update(MissionFlight flight, MissionPhase phase, bool isOver)
    {
        FinishDecisions(flight);
        while (flight.Operator.Pending is { } request)
        {
            bool isDecision = request.Command is OperatorCommand.Confirm or OperatorCommand.Reject;
            bool takesArea = request.Command == OperatorCommand.Continue && flight.Changes.IsAreaOffered && !isOver;
            if (takesArea && OperatorRules.OnlyTakesArea(phase))
            {
                TakeArea(flight, request);
                continue;
            }

            string? refusal = isOver && !isDecision
                ? "the mission is over"
                : OperatorRules.FindRefusal(phase, request.Command) ?? OperatorFaults.Find(flight, phase, request);
            if (takesArea && refusal is null)
                refusal = flight.Changes.TakeArea();
            if (refusal is not null)
                flight.Operator.Refuse(refusal);
            else if (OperatorRules.ChangesPhase(phase, request.Command))
                return;
            else if (isDecision)
                Decide(flight, request);
            else
                Do(flight, request);
        }
    }

    /// <summary>The manager ends.</summary>
    public void Close(MissionFlight flight)
    {
        foreach ((OperatorRequest request, TimeSpan _) in _decided)
            flight.Operator.Answer(request, OperatorOutcome.Refused, "the program ends");
        _decided.Clear();
    }

    private static void TakeArea(MissionFlight flight, OperatorRequest request)
    {
        string? refusal = OperatorFaults.Find(flight, MissionPhase.Searching, request) ?? flight.Changes.TakeArea();
        if (refusal is null)
            flight.Operator.Accept("over the new area");
        else
            flight.Operator.Refuse(refusal);
    }

    private static void Do(MissionFlight flight, OperatorRequest request)
    {
        string text = string.Empty;
        string? refusal = null;
        switch (request.Command)
        {
            case OperatorCommand.SkipLane:
                flight.SkipLane();
                break;
            case OperatorCommand.ChangeParameter:
                refusal = flight.Changes.Set(request.Parameter, request.Value);
                text = "from the next leg on";
                break;
            case OperatorCommand.OfferArea:
                refusal = flight.Changes.Offer(request.Area, request.KeepOuts);
                text = flight.Changes.IsAreaOffered ? "the next continue takes it over" : string.Empty;
                break;
            default:
                flight.Changes.SetSpeedNow(request.SpeedMetresPerSecond);
                break;
        }

        if (refusal is null)
            flight.Operator.Accept(text);
        else
            flight.Operator.Refuse(refusal);
    }

    private static TargetDecision DecisionOf(OperatorRequest request)
        => request.Command == OperatorCommand.Confirm ? TargetDecision.Confirmed : TargetDecision.Rejected;

    private void Decide(MissionFlight flight, OperatorRequest request)
    {
        if (decide(new TrackDecision { TrackId = request.TrackId, Decision = DecisionOf(request) }))
            _decided.Add((flight.Operator.PutAside()!, flight.Now));
        else
            flight.Operator.Refuse("Sensor Fusion takes nothing");
    }

    private void FinishDecisions(MissionFlight flight)
    {
        for (int i = 0; i < _decided.Count; i++)
        {
            (OperatorRequest request, TimeSpan since) = _decided[i];
            TargetTrack? track = Revisits.Find(flight, request.TrackId);
            bool isDone = track?.Decision == DecisionOf(request);
            if (!isDone && track is not null && flight.Now - since <= MaxDecisionTime)
                continue;
            _decided.RemoveAt(i--);
            if (isDone)
                flight.Operator.Answer(request, OperatorOutcome.Accepted, string.Empty);
            else
                flight.Operator.Answer(
                    request, OperatorOutcome.Refused,
                    track is null ? "the track is no more" : "Sensor Fusion does not answer");
        }
    }
}
