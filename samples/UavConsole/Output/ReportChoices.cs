using System.Collections.Generic;

namespace UavConsole;

/// <summary>What the command line asked for about the record of a flight.</summary>
internal sealed class ReportChoices
{
    /// <summary>Files for maps and tables; the end of the name says which.</summary>
    public IReadOnlyList<string> Exports { get; init; } = [];

    /// <summary>Who is responsible for the flight; empty where that was not said.</summary>
    public string OperatorName { get; init; } = string.Empty;
}
