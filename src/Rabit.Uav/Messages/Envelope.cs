using System;

namespace Rabit.Uav.Messages;

/// <summary>
/// A typed message between vehicles: what one manager pushes here falls into the queue of the manager over there that
/// receives the type. A plain value if its content is one.
/// </summary>
/// <typeparam name="T">What is inside; Communications has a route with a codec for each such type.</typeparam>
public struct Envelope<T>
{
    /// <summary>The content.</summary>
    public T Content { get; set; }

    /// <summary>Who it is for; set by the sender. All, if it is left out.</summary>
    public VehicleDestination Destination { get; set; }

    /// <summary>
    /// After this time, by the clock of the run, it is not sent any more; set by the sender. Zero: as long as the
    /// route says.
    /// </summary>
    public TimeSpan ValidUntil { get; set; }

    /// <summary>Whatever the sender knows it by: comes back in its <see cref="DeliveryReport"/>.</summary>
    public long Reference { get; set; }

    /// <summary>MAVLink system id of the vehicle that sent it; filled in by Communications where it comes in.</summary>
    public byte SourceSystemId { get; set; }

    /// <summary>
    /// When it was sent, by the clock of the run here; filled in where it comes in. Where
    /// <see cref="TimeAccuracy"/> is null it is late by the time on the way.
    /// </summary>
    public TimeSpan SentTime { get; set; }

    /// <summary>
    /// How far <see cref="SentTime"/> may be off, by the GPS times of both vehicles' autopilots; null marks the message
    /// of a vehicle without such a time, or that we have none.
    /// </summary>
    public TimeSpan? TimeAccuracy { get; set; }

    /// <summary>
    /// When it was sent by GPS, microseconds since 1970 UTC; 0 where its sender has no such time. Filled in where it
    /// comes in.
    /// </summary>
    public long SentUtcMicroseconds { get; set; }

    /// <summary>Whether it came over another vehicle; filled in where it comes in.</summary>
    public bool IsRelayed { get; set; }
}
