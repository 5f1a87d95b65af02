namespace Rabit.Mavlink;

/// <summary>How severe an event is, for the log or for people.</summary>
public enum MavlinkEventLevel
{
    /// <summary>The system is unusable.</summary>
    Emergency = 0,

    /// <summary>To be acted on at once.</summary>
    Alert = 1,

    /// <summary>A failure of a main system.</summary>
    Critical = 2,

    /// <summary>A failure of a secondary system.</summary>
    Error = 3,

    /// <summary>A possible failure later.</summary>
    Warning = 4,

    /// <summary>Unusual, no failure.</summary>
    Notice = 5,

    /// <summary>Of normal operation.</summary>
    Info = 6,

    /// <summary>For developers.</summary>
    Debug = 7,

    /// <summary>Between programs: not to be shown.</summary>
    Protocol = 8,

    /// <summary>Not to be shown or logged.</summary>
    Disabled = 9,
}
