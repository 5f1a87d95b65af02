using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

// What the vehicle has to say to people: texts, put together of their chunks, and the events of the autopilot.
public sealed partial class AutopilotManager
{
    // PX4 marks so the texts of events, for ground stations that show these.
    private const string EndOfEventText = "\t";

    private readonly MavlinkStatusTextReceiver _textReceiver = new();
    private MavlinkEventReceiver? _events;
    private MavlinkEventCatalog? _eventCatalog;
    private MavlinkEventCatalogClient? _eventFetch;
    private bool _isFetchingEvents;

    // Any component of the vehicle may have something to say to people.
    private VehicleEvents TakeText(in LinkFrame frame)
    {
        VehicleEvents events = Complete(frame, _tracker.Update(frame));
        if (_tracker.State.SystemId == 0 || frame.Frame.SystemId != _tracker.State.SystemId)
            return events;
        _textReceiver.Handle(frame.Frame, Now);
        TakeTexts(frame.Time);
        return events;
    }

    /// <summary>Takes the texts that are whole, or that nothing more comes of.</summary>
    /// <param name="time">When the last of them came in.</param>
    private void TakeTexts(TimeSpan time)
    {
        while (_textReceiver.TryTake(Now, out MavlinkStatusText text))
        {
            _executor.TakeText(text.Severity, text.Text, time);
            bool isOfEvent = _eventCatalog is not null && text.Text.EndsWith(EndOfEventText, StringComparison.Ordinal);
            if (!isOfEvent)
                Keep(new StatusText(time, text.Severity, text.Text));
        }
    }

    private void Keep(StatusText text) => _statusTexts.Value = _statusTexts.Value.With(text, RecentItemsKept);

    private VehicleEvents TakeEvent(in LinkFrame frame)
    {
        VehicleEvents events = Complete(frame, _tracker.Update(frame));
        if (!_tracker.IsFromAutopilot(frame.Frame))
            return events;
        if (frame.Frame.TryDecode(out Event happened))
            _executor.TakeEvent(happened.Id, frame.Time);
        _events?.Handle(frame.Frame, Now);
        while (_events is not null && _events.TryTake(out MavlinkEvent next))
            TakeEvent(next, frame.Time);
        return events;
    }

    private void TakeEvent(in MavlinkEvent happened, TimeSpan time)
    {
        if (!happened.IsForPeople)
            return;
        if (_eventCatalog?.Find(happened.Id) is { } known)
        {
            string text = known.MessageOf(happened);
            _executor.TakeEventText((MavSeverity)happened.Level, text);
            Keep(new StatusText(time, (MavSeverity)happened.Level, text));
        }
        else
        {
            Log($"the autopilot: {happened}");
        }
    }

    private void MakeEvents(MavlinkSender sender, MavlinkAddress target)
    {
        _events = new MavlinkEventReceiver(sender, target);
        _eventCatalog = _options.EventCatalog;
        if (_eventCatalog is null && _options.FetchesEventCatalog)
            _eventFetch = new MavlinkEventCatalogClient(sender, target);
    }

    // Found, or started again: perhaps with another firmware.
    private void BeginEvents(TimeSpan now)
    {
        _events?.Restart();
        _eventFetch?.Start(now);
        _isFetchingEvents = _eventFetch is not null;
    }

    private void RunEvents()
    {
        if (!_options.RequestsRates || !_tracker.State.IsConnected || _events is null)
            return;
        while (_events.TryTakeFrame(Now, out MavlinkFrame frame))
            _ = _outgoing.Push(new OutgoingFrame { Frame = frame });
        if (_eventFetch is not { } fetch || !_isFetchingEvents)
            return;
        while (fetch.TryTakeFrame(Now, out MavlinkFrame frame))
            _ = _outgoing.Push(new OutgoingFrame { Frame = frame });
        if (fetch.IsBusy)
            return;
        _isFetchingEvents = false;
        _eventCatalog = fetch.Catalog;
        Log(fetch.Failure is { } why
            ? $"no texts for the autopilot's events: {why}"
            : $"the autopilot has the texts of its {fetch.Catalog!.Count} events");
    }

    private void TakeMetadataFrame(in LinkFrame frame) => _eventFetch?.Handle(frame.Frame, Now);
}
