namespace Rabit.Mavlink.Speed;

/// <summary>How long is measured.</summary>
internal sealed record MeasurementEffort(int Passes, double SecondsWithoutGain)
{
    // The runtime makes its best code aside, for every kind of message separately: for 300 kinds that has taken 15 s on
    // a busy machine. So nothing is measured before this long has passed without a gain worth the name.
    public static MeasurementEffort Full { get; } = new(300, 3);

    /// <summary>Enough to notice a regression by a factor, not for figures.</summary>
    public static MeasurementEffort Quick { get; } = new(60, 1);
}
