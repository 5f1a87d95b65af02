using System;
using System.Collections.Generic;
using System.Linq;
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

    private static readonly TimeSpan MaxPlanTime = TimeSpan.FromSeconds(30);

    private readonly List<(OperatorRequest Request, TimeSpan Since)> _decided = [];
    private readonly HashSet<int> _rejectedAgain = [];
    private (OperatorRequest Request, PlanJob Job, TimeSpan Since)? _planned;

    /// <summary>In each tick.</summary>
    /// <param name="flight">The state of the mission.</param>
    /// <param name="phase">The phase.</param>
    /// <param name="isOver">Whether nothing more will happen.</param>
    public void Update(MissionFlight flight, MissionPhase phase, bool isOver)
    {
        FinishDecisions(flight);
        FinishPlan(flight);
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
            else if (request.Command is OperatorCommand.ChangeParameter or OperatorCommand.OfferArea)
                Change(flight, request);
            else
                Do(flight, request);
        }
    }

    /// <summary>What was rejected on an earlier flight is so again, once; the operator may say otherwise.</summary>
    public void RejectAgain(MissionFlight flight)
    {
        if (flight.Options.Resume is not { RejectedTargets.IsEmpty: false } progress)
            return;
        foreach (TargetTrack track in flight.Tracks.Tracks)
        {
            if (track.State == TrackState.Confirmed
                && progress.RejectedTargets.Any(r => ProgressTargets.AreSame(r, track)))
                RejectOnce(flight, track, "on an earlier flight");
        }
    }

    /// <summary>What the operator rejected at another vehicle is so here, once; ours may say otherwise.</summary>
    public void RejectToo(MissionFlight flight, TargetTrack track)
        => RejectOnce(flight, track, "by the operator of another vehicle");

    /// <summary>The manager ends.</summary>
    public void Close(MissionFlight flight)
    {
        foreach ((OperatorRequest request, TimeSpan _) in _decided)
            flight.Operator.Answer(request, OperatorOutcome.Refused, "the program ends");
        _decided.Clear();
        RefusePlanned(flight, "the program ends");
    }

    // What Sensor Fusion had no room for is tried again.
    private void RejectOnce(MissionFlight flight, TargetTrack track, string how)
    {
        if (track.Decision != TargetDecision.None || _rejectedAgain.Contains(track.Id)
            || !decide(new TrackDecision { TrackId = track.Id, Decision = TargetDecision.Rejected }))
            return;
        _rejectedAgain.Add(track.Id);
        flight.Log($"track {MissionNumbers.Of(track.Id)} was rejected {how}");
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
        if (request.Command == OperatorCommand.SkipLane)
        {
            flight.SkipLane();
        }
        else
        {
            flight.Changes.SetSpeedNow(request.SpeedMetresPerSecond);
        }

        flight.Operator.Accept();
    }

    // What is to be planned is answered when that is done; meanwhile it flies on.
    private void Change(MissionFlight flight, OperatorRequest request)
    {
        if (flight.Changes.Begin(request, out PlanJob? job) is { } refusal)
        {
            flight.Operator.Refuse(refusal);
        }
        else if (job is null)
        {
            flight.Operator.Accept(flight.Changes.TextOf(request));
        }
        else
        {
            RefusePlanned(flight, "replaced by a newer one");
            _planned = (flight.Operator.PutAside()!, job, flight.Now);
        }
    }

    private void FinishPlan(MissionFlight flight)
    {
        if (_planned is not { } planned)
            return;
        if (!planned.Job.IsDone && flight.Now - planned.Since > MaxPlanTime)
            RefusePlanned(flight, $"not planned within {MissionNumbers.Seconds(MaxPlanTime)}");
        if (!planned.Job.IsDone)
            return;
        _planned = null;
        string? fault = flight.Changes.Finish(planned.Request, planned.Job);
        flight.Operator.Answer(
            planned.Request, fault is null ? OperatorOutcome.Accepted : OperatorOutcome.Refused,
            fault ?? flight.Changes.TextOf(planned.Request));
    }

    private void RefusePlanned(MissionFlight flight, string why)
    {
        if (_planned is { } planned)
            flight.Operator.Answer(planned.Request, OperatorOutcome.Refused, why);
        _planned = null;
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

    // What was rejected at one vehicle stays so for the others: they may have acted on it.
    private static string EffectOf(MissionFlight flight, OperatorRequest request, TargetTrack track)
        => request.Command == OperatorCommand.Confirm && flight.Group?.IsRejected(flight, track) == true
            ? "for this vehicle alone: for the group it stays rejected"
            : string.Empty;

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
                flight.Operator.Answer(request, OperatorOutcome.Accepted, EffectOf(flight, request, track!));
            else
                flight.Operator.Answer(
                    request, OperatorOutcome.Refused,
                    track is null ? "the track is no more" : "Sensor Fusion does not answer");
        }
    }
}
