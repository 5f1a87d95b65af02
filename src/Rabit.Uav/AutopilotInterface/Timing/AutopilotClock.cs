using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Time synchronization: maps the autopilot's time since boot to our clock, by its answers to TIMESYNC, and where there
/// are none, by when its messages come in. No I/O, one thread, allocates nothing.
/// </summary>
internal sealed class AutopilotClock
{
    // The 32-bit milliseconds start again after 49.7 days.
    private const double WrapSeconds = 4_294_967.296;
    private const double SecondsPerNanosecond = 1e-9;

    // Without answers the delay of the link is not measured; radios of 57600 baud take about that long.
    private const double ErrorOfArrivalSeconds = 0.05;

    private readonly MavlinkTimesyncFilter _timesync = new();
    private readonly ArrivalFilter _arrival = new();

    /// <summary>When and whether to ask.</summary>
    public MavlinkTimesyncRequester Requests { get; } = new();

    /// <summary>The estimate of TIMESYNC.</summary>
    public MavlinkTimesyncFilter Timesync => _timesync;

    /// <summary>By what times are mapped.</summary>
    public ClockBasis BasisAt(TimeSpan now)
        => _timesync.IsKnown(now) ? ClockBasis.Timesync : _arrival.IsKnown ? ClockBasis.Arrival : ClockBasis.None;

    /// <summary>The autopilot has rebooted: its clock is another one.</summary>
    public void Restart(TimeSpan now)
    {
        _timesync.Clear();
        _arrival.Clear();
        if (Requests.IsStarted)
            Requests.Start(now);
    }

    /// <summary>Takes a TIMESYNC of the autopilot; requests and answers to others are none of ours.</summary>
    public void Take(in Timesync message, TimeSpan arrival)
    {
        if (!Requests.IsAnswer(message, out TimeSpan askedAt))
            return;
        if (_timesync.AddRoundTrip(askedAt, arrival, message.Tc1 * SecondsPerNanosecond))
            Requests.Hasten(arrival);
    }

    /// <summary>When something was true, by our clock.</summary>
    /// <param name="timeBootMs">What the autopilot's clock said; 0 where it does not know.</param>
    /// <param name="arrival">When the message came in; nothing was true later than that.</param>
    public TimeSpan Map(uint timeBootMs, TimeSpan arrival)
    {
        if (timeBootMs == 0)
            return arrival;
        TimeSpan theirs = new(timeBootMs * TimeSpan.TicksPerMillisecond);
        _arrival.Take(theirs, arrival);
        _timesync.AddOneWay(arrival, UnwrappedSeconds(theirs, arrival));
        TimeSpan ours = _timesync.IsKnown(arrival) ? ByTimesync(theirs, arrival) : theirs + _arrival.Offset;
        return ours < arrival ? ours : arrival;
    }

    /// <summary>The shortest round trip of a request, seconds; 0 while none was answered.</summary>
    public double RoundTripSeconds
        => double.IsNaN(_timesync.ShortestRoundTripSeconds) ? 0 : _timesync.ShortestRoundTripSeconds;

    /// <summary>One standard deviation of what is mapped, the same for all times, seconds.</summary>
    /// <remarks>
    /// One way may take all of the round trip and the other nothing, so that the offset is off by up to half of the
    /// shortest round trip, anything in between being as likely: its standard deviation is that by the square root
    /// of 3.
    /// </remarks>
    public double ErrorSecondsAt(TimeSpan now)
    {
        if (!_timesync.IsKnown(now))
            return ErrorOfArrivalSeconds;
        double ways = _timesync.ShortestRoundTripSeconds / 2;
        double estimate = _timesync.OffsetErrorSecondsAt(now.ExactSeconds);
        return Math.Sqrt((ways * ways / 3) + (estimate * estimate));
    }

    private TimeSpan ByTimesync(TimeSpan theirs, TimeSpan arrival)
        => new(
            (long)Math.Round(
                (UnwrappedSeconds(theirs, arrival) - _timesync.OffsetSecondsAt(arrival.ExactSeconds))
                    * TimeSpan.TicksPerSecond));

    // The answers' clock has 64 bits.
    private double UnwrappedSeconds(TimeSpan theirs, TimeSpan arrival)
    {
        double now = arrival.ExactSeconds + _timesync.OffsetSecondsAt(arrival.ExactSeconds);
        return theirs.ExactSeconds + (Math.Round((now - theirs.ExactSeconds) / WrapSeconds) * WrapSeconds);
    }
}
