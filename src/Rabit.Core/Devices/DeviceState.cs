namespace Rabit.Core;

/// <summary>Where a blocking reader or writer is in its life.</summary>
public enum DeviceState
{
    /// <summary>Not yet running: its manager has not started.</summary>
    Created,

    /// <summary>Reading or writing.</summary>
    Running,

    /// <summary>The source has nothing more to give, now and later.</summary>
    Ended,

    /// <summary>The source or target threw; see the fault.</summary>
    Faulted,

    /// <summary>Stopped with its manager.</summary>
    Stopped,

    /// <summary>The source or target threw; it is closed, and will be opened again.</summary>
    Reconnecting,
}
