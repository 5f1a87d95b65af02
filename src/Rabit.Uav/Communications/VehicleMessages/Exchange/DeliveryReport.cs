namespace Rabit.Uav.Communications;

/// <summary>
/// What became of one message to other vehicles. A plain value; exactly one for each that asked for it.
/// </summary>
internal struct DeliveryReport
{
    /// <summary>The reference that the sender gave it.</summary>
    public long Reference { get; set; }

    /// <summary>What became of it.</summary>
    public DeliveryOutcome Outcome { get; set; }

    /// <summary>How many vehicles it was for, by those that were received when it was posted.</summary>
    public int Receivers { get; set; }

    /// <summary>How many of them have acknowledged it.</summary>
    public int Acknowledged { get; set; }

    /// <summary>How many of them do not understand it.</summary>
    public int NotUnderstood { get; set; }
}
