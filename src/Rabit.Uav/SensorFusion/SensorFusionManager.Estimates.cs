using System;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

// Tracks of other vehicles: what a vehicle knows of targets that move and that it has not seen itself.
public sealed partial class SensorFusionManager
{
    // In turn, where there are more. Five are 0.5 kbit/s with all headers: the radio at rest stays below 2.
    private const int MaxEstimatesAtOnce = 5;

    private static readonly TimeSpan EstimatePeriod = TimeSpan.FromSeconds(10);

    // What was not seen for longer may be anywhere.
    private static readonly TimeSpan MaxEstimateAge = TimeSpan.FromSeconds(30);

    private readonly QueueReceiver<Envelope<TrackEstimate>>? _foreignEstimates;
    private readonly QueueSender<Envelope<TrackEstimate>>? _outgoingEstimates;
    private TimeSpan _estimatesSent;
    private int _lastSharedTrack;

    private bool PopForeignEstimates(TimeSpan now)
    {
        bool hasSome = false;
        while (_foreignEstimates is not null && _foreignEstimates.TryPop(out Envelope<TrackEstimate> envelope))
        {
            Take(envelope.Content, now);
            hasSome = true;
        }

        return hasSome;
    }

    private void Take(in TrackEstimate estimate, TimeSpan now)
    {
        ReportFault fault = EstimateCheck.FaultOf(estimate, now, MaxEstimateAge);
        if (fault != ReportFault.None)
        {
            Refuse(estimate, fault);
            return;
        }

        // Reports have indexes from 0 on.
        if (!_seen.Add(new ReportKey(estimate.SourceSystemId, estimate.PictureNumber, -estimate.TrackId)))
        {
            _statistics.EstimatesTwice++;
            return;
        }

        if (_moving?.Has(estimate.Class) != true)
        {
            _statistics.EstimatesNotNeeded++;
            return;
        }

        // A frame that is there stays: the estimate is not confirmed by anything.
        if (_frame is null)
            Anchor(estimate.Position);
        NedPosition place = _frame!.Value.ToNed(estimate.Position);
        if (IsFarAway(place))
            Refuse(estimate, ReportFault.Position);
        else if (_moving.Update(estimate, place))
            NoteChange(estimate.Time > now ? now : estimate.Time);
    }

    private void Refuse(in TrackEstimate estimate, ReportFault fault)
    {
        _statistics.EstimatesRefused++;
        _statistics.Refusals.Add(estimate.SourceSystemId, fault);
    }

    private void NoteChange(TimeSpan time)
    {
        _isChanged = true;
        if (time > _newest)
            _newest = time;
    }

    // Also of targets that are not seen now: reports of these do not go out.
    private void ShareEstimates(TimeSpan now)
    {
        if (_outgoingEstimates is null || _moving is null || _frame is not { } frame
            || now - _estimatesSent < EstimatePeriod)
            return;
        _estimatesSent = now;
        _isChanged |= _moving.DeleteUnconfirmedOfOthers(now - MaxEstimateAge);
        Send([.. _moving.Estimates(frame, now - MaxEstimateAge)], _lastSharedTrack);
    }

    private void Send(TrackEstimate[] known, int last)
    {
        foreach (TrackEstimate estimate in known.OrderBy(e => e.TrackId <= last).ThenBy(e => e.TrackId)
            .Take(MaxEstimatesAtOnce))
        {
            // A full queue counts that itself.
            _ = _outgoingEstimates!.Push(new Envelope<TrackEstimate> { Content = estimate });
            _lastSharedTrack = estimate.TrackId;
        }
    }
}
