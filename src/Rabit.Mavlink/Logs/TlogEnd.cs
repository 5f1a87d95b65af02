namespace Rabit.Mavlink;

/// <summary>How reading a telemetry log ended.</summary>
public enum TlogEnd
{
    /// <summary>There is more to read.</summary>
    NotReached,

    /// <summary>
    /// All of the file was read and it holds at least one intact record. Damage, if any, is counted separately:
    /// <see cref="TlogReader.LostBytes"/>.
    /// </summary>
    Complete,

    /// <summary>The file has no bytes: a log of nothing.</summary>
    Empty,

    /// <summary>The file has bytes but not one intact record: it is no telemetry log, or damaged all through.</summary>
    NoRecord,
}
