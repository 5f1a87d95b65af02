using System.Collections.Generic;
using Rabit.Uav.Links;

namespace UavConsole;

/// <summary>What the command line asked for.</summary>
internal sealed class ConsoleOptions(IReadOnlyList<LinkUrl> links, bool isHeadless, string? summaryFile, byte? systemId)
{
    /// <summary>Links in the order given; the bundled flight when none was.</summary>
    public IReadOnlyList<LinkUrl> Links { get; } = links;

    /// <summary>Plain lines instead of a live screen.</summary>
    public bool IsHeadless { get; } = isHeadless;

    /// <summary>Where the summary goes as JSON; null for nowhere.</summary>
    public string? SummaryFile { get; } = summaryFile;

    /// <summary>Our MAVLink system id; null for that of the vehicle.</summary>
    public byte? SystemId { get; } = systemId;
}
