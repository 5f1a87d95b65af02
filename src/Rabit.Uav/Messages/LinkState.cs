namespace Rabit.Uav.Messages;

/// <summary>How a link is.</summary>
public enum LinkState
{
    /// <summary>Open, but nothing came in yet.</summary>
    Waiting,

    /// <summary>Frames come in.</summary>
    Receiving,

    /// <summary>Frames came in, but not any more.</summary>
    Silent,

    /// <summary>The other end closed it, or the log is at its end.</summary>
    Ended,

    /// <summary>It failed; see the log of the run.</summary>
    Failed,

    /// <summary>It is not open, or not any more, and is tried again and again.</summary>
    Opening,
}
