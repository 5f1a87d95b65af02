using System;
using System.Threading;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// One route of vehicle messages at work: between its queues and the exchange. Communications' thread uses it; any
/// thread may ask for the counts.
/// </summary>
internal abstract class VehicleMessageChannel(VehicleMessageRoute route, QueueSender<DeliveryReport>? reports)
{
    private long _posted;
    private long _unsendable;
    private long _sent;
    private long _acknowledged;
    private long _undelivered;
    private long _reportsDropped;
    private long _delivered;
    private long _malformed;
    private long _noRoom;

    private protected enum DeliveryResult
    {
        Delivered,
        Malformed,
        NoRoom,
    }

    public VehicleMessageRoute Route => route;

    public VehicleMessageCounters Counts => new()
    {
        MessageType = route.MessageType,
        Posted = Interlocked.Read(ref _posted),
        Unsendable = Interlocked.Read(ref _unsendable),
        Sent = Interlocked.Read(ref _sent),
        Acknowledged = Interlocked.Read(ref _acknowledged),
        Undelivered = Interlocked.Read(ref _undelivered),
        ReportsDropped = Interlocked.Read(ref _reportsDropped),
        Delivered = Interlocked.Read(ref _delivered),
        Malformed = Interlocked.Read(ref _malformed),
        NoRoom = Interlocked.Read(ref _noRoom),
    };

    /// <summary>Gives the exchange what is to be sent.</summary>
    /// <param name="exchange">The exchange.</param>
    /// <param name="now">The time.</param>
    /// <returns>Whether there was something.</returns>
    public bool Post(MessageExchange exchange, TimeSpan now)
    {
        bool hasPosted = false;
        while (TryTake(now, out ExchangeMessage? message, out DeliveryReport refused))
        {
            Interlocked.Increment(ref _posted);
            hasPosted = true;
            if (exchange.SystemId == 0)
                refused.Outcome = DeliveryOutcome.Unsendable;
            if (message is null || exchange.SystemId == 0)
                Report(refused);
            else
                exchange.Post(message, now);
        }

        return hasPosted;
    }

    /// <summary>Says what became of a message.</summary>
    public void Report(in DeliveryReport report)
    {
        switch (report.Outcome)
        {
            case DeliveryOutcome.Delivered:
                Interlocked.Increment(ref _acknowledged);
                break;
            case DeliveryOutcome.Sent:
                Interlocked.Increment(ref _sent);
                break;
            case DeliveryOutcome.Unsendable:
                Interlocked.Increment(ref _unsendable);
                break;
            default:
                Interlocked.Increment(ref _undelivered);
                break;
        }

        if (reports is { } queue && queue.Push(report) == PushResult.Rejected)
            Interlocked.Increment(ref _reportsDropped);
    }

    /// <summary>Takes what another vehicle sent.</summary>
    /// <param name="message">The message; of our type.</param>
    /// <param name="sentTime">When it was sent, by the clock of the run here.</param>
    /// <param name="accuracy">How far that may be off; null where there is no common time.</param>
    public void Take(ReceivedExchangeMessage message, TimeSpan sentTime, TimeSpan? accuracy)
    {
        switch (Deliver(message, sentTime, accuracy))
        {
            case DeliveryResult.Delivered:
                Interlocked.Increment(ref _delivered);
                break;
            case DeliveryResult.Malformed:
                Interlocked.Increment(ref _malformed);
                break;
            default:
                Interlocked.Increment(ref _noRoom);
                break;
        }
    }

    // A message that cannot be sent is null; what becomes of it is said instead.
    private protected abstract bool TryTake(TimeSpan now, out ExchangeMessage? message, out DeliveryReport refused);

    private protected abstract DeliveryResult Deliver(
        ReceivedExchangeMessage message, TimeSpan sentTime, TimeSpan? accuracy);
}
