namespace Rabit.Uav.Messages;

/// <summary>
/// What became of one message to other vehicles: exactly one for each that was taken from the queue of its route. A
/// plain value.
/// </summary>
public struct DeliveryReport
{
    /// <summary>The reference that the sender gave it: <see cref="Envelope{T}.Reference"/>.</summary>
    public long Reference { get; set; }

    /// <summary>What became of it.</summary>
    public DeliveryOutcome Outcome { get; set; }

    /// <summary>
    /// How many vehicles must acknowledge it: one, or those of all or of the group that were received when it was
    /// posted; 0 where none must.
    /// </summary>
    public int Receivers { get; set; }

    /// <summary>How many of them have acknowledged it.</summary>
    public int Acknowledged { get; set; }

    /// <summary>How many of them do not understand it.</summary>
    public int NotUnderstood { get; set; }
}
