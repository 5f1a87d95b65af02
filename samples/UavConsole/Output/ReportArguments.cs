using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Parsing;

namespace UavConsole;

/// <summary>The options of what is written about a flight beside summary, report and log.</summary>
internal static class ReportArguments
{
    private const int MaxNameLength = 100;

    private static readonly Option<string[]> Export = new("--export")
    {
        Description = "Writes path, targets with their 95 % ellipses, area and seen ground for a map or a table: "
            + "FILE.geojson, FILE.kml or FILE.csv; may be given several times. A file that is there is kept beside it, "
            + "under its date.",
        HelpName = "FILE",
        AllowMultipleArgumentsPerToken = false,
        CustomParser = ParseExports,
    };

    private static readonly Option<string?> Operator = new("--operator")
    {
        Description = "Who is responsible for the flight, for the report.",
        HelpName = "NAME",
        CustomParser = ParseName,
    };

    /// <summary>All of them.</summary>
    public static IEnumerable<Option> All => [Export, Operator];

    public static ReportChoices Read(ParseResult result) => new()
    {
        Exports = result.GetValue(Export) ?? [],
        OperatorName = result.GetValue(Operator) ?? string.Empty,
    };

    private static string[] ParseExports(ArgumentResult result)
    {
        var files = new List<string>();
        foreach (Token token in result.Tokens)
        {
            if (ExportFormat.Find(token.Value) is null)
                result.AddError($"--export {token.Value}: its name must end in {ExportFormat.Endings}.");
            else
                files.Add(token.Value);
        }

        return files.ToArray();
    }

    private static string? ParseName(ArgumentResult result)
    {
        string name = result.Tokens[0].Value.Trim();
        if (name.Length is > 0 and <= MaxNameLength)
            return name;
        result.AddError($"--operator: a name has 1 to {MaxNameLength} characters.");
        return null;
    }
}
