namespace Rabit.Links;

/// <summary>What came of reading a link.</summary>
public enum LinkReadKind
{
    /// <summary>There is nothing to read at the moment. Only a link that does not block says so.</summary>
    NothingYet,

    /// <summary>Bytes came.</summary>
    Bytes,

    /// <summary>The link has ended; nothing will ever come again.</summary>
    Ended,
}
