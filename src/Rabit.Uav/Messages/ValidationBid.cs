namespace Rabit.Uav.Messages;

/// <summary>What a vehicle says to a <see cref="ValidationTask"/>, to its finder. A plain value.</summary>
public struct ValidationBid
{
    /// <summary>The session of the task.</summary>
    public ushort Session { get; set; }

    /// <summary>The number of the task.</summary>
    public ushort Number { get; set; }

    /// <summary>The award that it is an answer to.</summary>
    public ushort Award { get; set; }

    /// <summary>What it says.</summary>
    public ValidationBidState State { get; set; }

    /// <summary>After what time it would be there, seconds; up to 18 hours.</summary>
    public double Seconds { get; set; }

    /// <summary>The result, once it is finished.</summary>
    public ValidationResult Result { get; set; }
}
