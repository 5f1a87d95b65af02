using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The operator's requests: given by any thread, carried out in their order by the manager's, each answered and logged.
/// One that could not be carried out in time is refused, so that it does not come true minutes later.
/// </summary>
internal sealed class OperatorRequests(Action<string> log)
{
    private const int MaxWaiting = 32;

    // Long enough for a short loss of the link, short enough for the operator to remember it.
    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(10);

    private readonly ConcurrentQueue<OperatorRequest> _given = new();
    private readonly List<(OperatorRequest Request, TimeSpan Since)> _waiting = [];
    private volatile bool _isClosed;

    /// <summary>The request that is to be carried out next; null where there is none.</summary>
    public OperatorRequest? Pending => _waiting.Count > 0 ? _waiting[0].Request : null;

    /// <summary>The request that was begun and is not answered yet; null where there is none.</summary>
    public OperatorRequest? InHand { get; private set; }

    /// <summary>Gives a request. Any thread.</summary>
    public void Give(OperatorRequest request)
    {
        _given.Enqueue(request);
        if (_isClosed)
            RefuseGiven();
    }

    /// <summary>Takes in what was given, and refuses what is too old.</summary>
    /// <param name="now">The time of this tick.</param>
    /// <param name="keepsReturn">Whether a return waits without limit: we command, and the link is lost.</param>
    public void Update(TimeSpan now, bool keepsReturn)
    {
        while (_given.TryDequeue(out OperatorRequest? given))
        {
            log($"operator {given.By}: {given.Name}, {given.Reason}");
            if (_waiting.Count < MaxWaiting)
                _waiting.Add((given, now));
            else
                Answer(given, OperatorOutcome.Refused, $"{MissionNumbers.Of(MaxWaiting)} others wait already");
        }

        for (int i = _waiting.Count - 1; i >= 0; i--)
        {
            (OperatorRequest request, TimeSpan since) = _waiting[i];
            if (now - since <= MaxAge || (keepsReturn && request.Command == OperatorCommand.Return))
                continue;
            _waiting.RemoveAt(i);
            Answer(request, OperatorOutcome.Refused, $"not possible within {MissionNumbers.Seconds(MaxAge)}");
        }
    }

    /// <summary>The next request is begun; it is answered later.</summary>
    public OperatorRequest? Begin()
    {
        if (InHand is not null)
            AnswerInHand(OperatorOutcome.Refused, "replaced by a newer command");
        InHand = Pending;
        if (InHand is not null)
            _waiting.RemoveAt(0);
        return InHand;
    }

    /// <summary>The request that was begun, or the next one, is carried out.</summary>
    public OperatorRequest? Accept(string text = "")
    {
        OperatorRequest? accepted = InHand ?? Begin();
        AnswerInHand(OperatorOutcome.Accepted, text);
        return accepted;
    }

    /// <summary>The next request is not carried out; does nothing where there is none.</summary>
    public void Refuse(string why)
    {
        if (Pending is not { } refused)
            return;
        _waiting.RemoveAt(0);
        Answer(refused, OperatorOutcome.Refused, why);
    }

    /// <summary>The request that was begun is not carried out; does nothing where there is none.</summary>
    public void RefuseInHand(string why) => AnswerInHand(OperatorOutcome.Refused, why);

    /// <summary>Neither what was begun nor what waits is carried out.</summary>
    public void RefuseAll(string why)
    {
        RefuseInHand(why);
        while (Pending is not null)
            Refuse(why);
    }

    /// <summary>Takes the request that was begun out of hand: its answer comes later, from elsewhere.</summary>
    public OperatorRequest? PutAside()
    {
        OperatorRequest? request = Pending;
        if (request is not null)
            _waiting.RemoveAt(0);
        return request;
    }

    /// <summary>Answers a request that was put aside.</summary>
    public void Answer(OperatorRequest request, OperatorOutcome outcome, string text)
    {
        request.Set(outcome, text);
        string end = text.Length == 0 ? string.Empty : ": " + text;
        log($"operator {request.By}'s {request.Name} {(outcome == OperatorOutcome.Accepted ? "accepted" : "refused")}"
            + end);
    }

    /// <summary>The manager ends: whatever waits or comes later is refused.</summary>
    public void Close()
    {
        _isClosed = true;
        RefuseAll(Ended);
        RefuseGiven();
    }

    private const string Ended = "the program ends";

    private void RefuseGiven()
    {
        while (_given.TryDequeue(out OperatorRequest? given))
            given.Set(OperatorOutcome.Refused, Ended);
    }

    private void AnswerInHand(OperatorOutcome outcome, string text)
    {
        if (InHand is not { } request)
            return;
        InHand = null;
        Answer(request, outcome, text);
    }
}
