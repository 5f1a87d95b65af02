namespace Rabit.Uav.Communications;

/// <summary>How urgent a frame is on a link with a budget. The first goes first.</summary>
internal enum SendClass
{
    /// <summary>P0: heartbeats, emergency texts, the commands to return, land and end the flight.</summary>
    Urgent,

    /// <summary>P1: commands, their acknowledgements, set-points, what measures time.</summary>
    Commands,

    /// <summary>P2: messages between vehicles, texts and events, each of which counts.</summary>
    Coordination,

    /// <summary>P3: state, of which the latest value counts.</summary>
    State,

    /// <summary>P4: what is large and can wait: parameters, missions, files, logs, and what is not known.</summary>
    Bulk,
}
