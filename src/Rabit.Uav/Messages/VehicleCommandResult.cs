namespace Rabit.Uav.Messages;

/// <summary>What became of a <see cref="VehicleCommand"/>. Exactly one for each. A plain value.</summary>
public struct VehicleCommandResult
{
    /// <summary>The id of the command.</summary>
    public long Id { get; set; }

    /// <summary>What was to be done.</summary>
    public VehicleCommandKind Kind { get; set; }

    /// <summary>What became of it.</summary>
    public VehicleCommandOutcome Outcome { get; set; }

    /// <summary>Why, for people; null where it was accepted.</summary>
    public string? Text { get; set; }
}
