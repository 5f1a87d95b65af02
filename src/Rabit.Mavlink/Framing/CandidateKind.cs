namespace Rabit.Mavlink;

/// <summary>What can be said of a possible frame from its header alone.</summary>
internal enum CandidateKind
{
    /// <summary>No frame begins here.</summary>
    NotAFrame,

    /// <summary>It begins like a frame; the rest of the header has not arrived.</summary>
    HeaderIncomplete,

    /// <summary>The id is known: the checksum will tell.</summary>
    Checkable,

    /// <summary>The id is unknown, so that the checksum cannot be checked.</summary>
    Uncheckable,
}
