using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// Sends the heartbeat of our component at a fixed period (MAVLink guide, "Heartbeat/Connection Protocol"). No I/O, no
/// clock: frames out, time as argument. One thread; nothing is allocated per frame. The other direction is
/// <see cref="MavlinkHeartbeatTracker"/>.
/// </summary>
/// <remarks>
/// The guide wants no heartbeat of a component that has failed: call <see cref="TryTakeFrame"/> from the loop that does
/// the work, so that heartbeats stop with it, and set <see cref="Enabled"/> to false where the component finds itself
/// unable to work.
/// </remarks>
/// <example>
/// <code>
/// var sender = new MavlinkSender(systemId: 1, componentId: 191);
/// var heartbeats = new MavlinkHeartbeatSender(
///     sender, new Heartbeat { Type = MavType.OnboardController, MavlinkVersion = 3 });
///
/// // In the loop, and at heartbeats.NextDue at the latest:
/// static void Step(MavlinkHeartbeatSender heartbeats, TimeSpan now, Stream link, byte[] buffer)
/// {
///     while (heartbeats.TryTakeFrame(now, out MavlinkFrame frame))
///         link.Write(buffer, 0, frame.WriteTo(buffer));
/// }
/// </code>
/// </example>
public sealed class MavlinkHeartbeatSender
{
    /// <summary>The period that the MAVLink guide recommends: 1 s.</summary>
    public static readonly TimeSpan DefaultPeriod = TimeSpan.FromSeconds(1);

    private readonly MavlinkSender _sender;
    private readonly TimeSpan _period;
    private TimeSpan _due;
    private bool _hasSent;

    /// <summary>Makes a sender of heartbeats; the first is due at once.</summary>
    /// <param name="sender">Gives the frames their source, sequence numbers and signatures.</param>
    /// <param name="heartbeat">The message, until <see cref="Heartbeat"/> is set.</param>
    /// <param name="period">Above zero; null for <see cref="DefaultPeriod"/>.</param>
    /// <exception cref="ArgumentNullException">No sender.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The period is not above zero.</exception>
    public MavlinkHeartbeatSender(MavlinkSender sender, Heartbeat heartbeat, TimeSpan? period = null)
    {
        _sender = sender ?? throw new ArgumentNullException(nameof(sender));
        _period = period ?? DefaultPeriod;
        if (_period <= TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(period), period, "The period is above zero.");
        Heartbeat = heartbeat;
    }

    /// <summary>
    /// The message: set it when the state or the mode of the component changes. It is sent when it is due, not at once.
    /// </summary>
    public Heartbeat Heartbeat { get; set; }

    /// <summary>Whether heartbeats are sent; true at first.</summary>
    public bool Enabled { get; set; } = true;

    /// <summary>
    /// When to call <see cref="TryTakeFrame"/> at the latest; <see cref="TimeSpan.MaxValue"/> while disabled. A time in
    /// the past means at once.
    /// </summary>
    public TimeSpan NextDue => Enabled ? _due : TimeSpan.MaxValue;

    /// <summary>Takes the heartbeat to send, if it is due. Call it until there is none.</summary>
    /// <param name="now">The time, by a clock that never goes back.</param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
    {
        frame = default;
        if (!Enabled || (_hasSent && now < _due))
            return false;

        // On a grid, so that late calls do not slow it down; missed heartbeats are not made up for.
        _due = _hasSent && now < _due + _period ? _due + _period : now + _period;
        _hasSent = true;
        frame = _sender.Create(Heartbeat);
        return true;
    }
}
