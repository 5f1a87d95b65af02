namespace MavlinkDump;

/// <summary>The exit codes of the program.</summary>
internal static class ExitCodes
{
    /// <summary>The log was read to its end and what was asked for was there.</summary>
    public const int Done = 0;

    /// <summary>The log was read to its end, but nothing that was asked for is in it.</summary>
    public const int NothingFound = 1;

    /// <summary>The command line makes no sense, or the file cannot be read or is no log.</summary>
    public const int BadInput = 2;
}
